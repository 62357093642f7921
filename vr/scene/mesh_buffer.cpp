#include "vr/scene/mesh_buffer.h"

#include <QOpenGLExtraFunctions>

template class core::TintBuffer<QOpenGLExtraFunctions>;
template class core::ClayBuffer<QOpenGLExtraFunctions>;
