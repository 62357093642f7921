#include "ui/scene/mesh_buffer.h"

#include <QOpenGLFunctions_3_3_Core>

template class core::TintBuffer<QOpenGLFunctions_3_3_Core>;
template class core::ClayBuffer<QOpenGLFunctions_3_3_Core>;
