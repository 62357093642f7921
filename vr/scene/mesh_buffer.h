#pragma once

#include "core/render/mesh_buffer.h"

class QOpenGLExtraFunctions;

extern template class core::VertexWeightBuffer<QOpenGLExtraFunctions>;
extern template class core::MeshBuffer<QOpenGLExtraFunctions>;

namespace vr
{
using MeshBuffer = core::MeshBuffer<QOpenGLExtraFunctions>;
} // namespace vr
