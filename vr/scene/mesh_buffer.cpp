#include "vr/scene/mesh_buffer.h"

#include <QOpenGLExtraFunctions>

template class core::VertexWeightBuffer<QOpenGLExtraFunctions>;
template class core::MeshBuffer<QOpenGLExtraFunctions>;
