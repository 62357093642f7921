#pragma once

#include "core/mesh/mesh.h"
#include "core/operations/model_command.h"

namespace core
{
/// Changes the whole model's mask; nothing else of it. Precondition: a stroke is open. O(mesh), steps of a ring at a
/// time.
void applyMaskOperation(Mesh& mesh, const MaskOperation& command);
} // namespace core
