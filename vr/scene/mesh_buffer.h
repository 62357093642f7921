#pragma once

#include "core/render/mesh_buffer.h"

class QOpenGLExtraFunctions;

extern template class core::TintBuffer<QOpenGLExtraFunctions>;
extern template class core::ClayBuffer<QOpenGLExtraFunctions>;

namespace vr
{
using ClayBuffer = core::ClayBuffer<QOpenGLExtraFunctions>;
} // namespace vr
