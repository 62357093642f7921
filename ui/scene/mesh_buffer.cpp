#include "ui/scene/mesh_buffer.h"

#include <QOpenGLFunctions_3_3_Core>

template class core::VertexWeightBuffer<QOpenGLFunctions_3_3_Core>;
template class core::MeshBuffer<QOpenGLFunctions_3_3_Core>;
