#pragma once

#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/select/region.h"
#include "core/sculpt/verify/verified_mesh.h"
#include "core/stroke/stroke.h"

namespace core
{
class BrushModel;

/// Whether the dab is to add a solid: the stroke asks for that, and nothing is under the brush. `region`: what it
/// selects.
bool wantsSolid(const VerifiedMesh& surface, const StrokeSettings& settings, const Dab& dab, const Region& region);

/// Returns why spheres of that radius may not be added at these places together, if so. Equal places count once.
Refusal refusalOf(const VerifiedMesh& surface, const std::vector<Vec3>& centers, double radius);

/// Adds a sphere of the dab's radius, or the brush's model in it, upright (free topology: paper, section 3.5.1). The
/// sphere must lie outside the surface, clear of it, and inside the working volume; a solid that is refused changes
/// nothing. `mirror`: null, or one in which the image is added, too, or neither is. A solid whose centre is on the
/// mirror's plane counts as its own image, another must be clear of its image. Precondition: a stroke is open.
DabReport addSolid(VerifiedMesh& surface, const BrushModel* model, const Dab& dab, const MirrorMap* mirror);
} // namespace core
