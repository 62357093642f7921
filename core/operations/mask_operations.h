#pragma once

#include "core/mesh/mesh.h"
#include "core/operations/model_command.h"

namespace core
{
/// Changes the mask of the whole model and nothing else. Precondition: a stroke of the mesh is open. Cost: O(mesh).
void applyMaskOperation(Mesh& mesh, const MaskOperation& command);
} // namespace core
