#pragma once

#include "core/mesh/mesh.h"
#include "core/operations/model_command.h"

namespace core
{
/// Changes the mask of the whole model and nothing else. Precondition: a stroke of the mesh is open. Cost: O(mesh).
void applyMaskOperation(Mesh& mesh, const MaskOperation& command);
/// Hides vertices of the part, or of all parts; shows all of all parts if Hide::showsAll(), with Hide::What::NoPart
/// also hidden parts. Changes nothing else, and hides nothing if nothing is masked. Precondition and cost as above.
void applyHide(Mesh& mesh, const Hide& command, std::optional<PartId> part);
/// Masks, or unmasks, the part's vertices in an area of the view, and nothing else; or hides them. Refuses with
/// NoOutline if the curve has no area. Precondition as above. Cost: verticesIn().
void applyMaskArea(Mesh& mesh, const MaskArea& command, std::optional<PartId> part, ModelChange& change);
void applyHideArea(Mesh& mesh, const HideArea& command, std::optional<PartId> part, ModelChange& change);
} // namespace core
