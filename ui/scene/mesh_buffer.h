#pragma once

#include "core/render/mesh_buffer.h"

class QOpenGLFunctions_3_3_Core;

extern template class core::TintBuffer<QOpenGLFunctions_3_3_Core>;
extern template class core::ClayBuffer<QOpenGLFunctions_3_3_Core>;

namespace ui
{
using ClayBuffer = core::ClayBuffer<QOpenGLFunctions_3_3_Core>;
} // namespace ui
