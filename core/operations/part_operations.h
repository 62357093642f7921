#pragma once

#include "core/mesh/mesh.h"
#include "core/operations/model_command.h"

namespace core
{
/// Returns why the part cannot be changed; None if it can.
ModelRefusal refusalOf(const Mesh& mesh, PartId part);
/// Applies EditPart or ShowParts to the list. `part`: the part that EditPart changes. Returns NoSuchPart if there is
/// none.
ModelRefusal editParts(PartList& parts, const ModelCommand& command, PartId part);
/// Applies another command on parts to a mesh whose stroke is open. `part`: see applyToCopy(). Sets change.refusal, and
/// leaves the mesh in an unspecified state, if it cannot be done.
void applyToParts(Mesh& mesh, const ModelCommand& command, std::optional<PartId> part, ModelChange& change,
                  const JobControl& control);
} // namespace core
