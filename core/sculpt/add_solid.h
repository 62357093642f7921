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

/// Why spheres of that radius may not be added at these places together, if so; what stands there twice is one.
Refusal refusalOf(const VerifiedMesh& surface, const std::vector<Vec3>& centers, double radius);

/// Free topology (paper, section 3.5.1): adds a sphere of the dab's radius, or the brush's model in it, upright, if
/// that sphere lies outside the surface, clear of it and inside the working volume. With a mirror (or none: null) its
/// image is added too, or neither is; one whose centre is on the plane is its own image, or a model is taken for that,
/// another must be clear of its image. A refused one changes nothing. Precondition: a stroke is open.
DabReport addSolid(VerifiedMesh& surface, const BrushModel* model, const Dab& dab, const MirrorMap* mirror);
} // namespace core
