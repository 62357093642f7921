#pragma once

#include "core/area/view_area.h"
#include "core/mesh/mesh.h"

namespace core
{
/// Returns for each vertex slot whether the vertex is in the area. With symmetry, the mirror image of the area belongs
/// to it. Counts only vertices of this part, if one is given, and none that are hidden.
///
/// ViewArea::isFrontOnly: counts only vertices that face the eye and are not behind clay that is shown, of any part;
/// those of the mirror image are judged from the eye's mirror image.
///
/// Nothing if the curve has no area or is too tangled, or a corner is beside or behind the eye. Thread: any; uses all
/// cores. Cost: the part's vertices; if only the front counts, a sort of all faces, and a line of sight per vertex.
std::optional<std::vector<bool>> verticesIn(const ViewArea& area, const Mesh& mesh, std::optional<PartId> part);
} // namespace core
