#pragma once

#include "core/render/mesh_buffer.h"

class QOpenGLFunctions_3_3_Core;

extern template class core::VertexWeightBuffer<QOpenGLFunctions_3_3_Core>;
extern template class core::MeshBuffer<QOpenGLFunctions_3_3_Core>;

namespace ui
{
using MeshBuffer = core::MeshBuffer<QOpenGLFunctions_3_3_Core>;
} // namespace ui
