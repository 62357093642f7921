#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// Returns whether the dab is to add a solid: the stroke's settings ask for it, and either nothing is under the brush
/// or the solid may join the model. `region`: the vertices that the dab selects.
bool wantsSolid(const VerifiedMesh& surface, const StrokeSettings& settings, const Dab& dab, const Region& region);

/// Returns the reason why spheres of this radius cannot all be added at these centres; Refusal::None if they can. Equal
/// centres count once.
Refusal refusalOf(const VerifiedMesh& surface, const std::vector<Vec3>& centers, double radius);

/// Adds a sphere of the dab's radius, or the brush's model, upright and scaled to that radius (free topology: paper,
/// section 3.5.1). Writes the outcome to the context's report. A refused solid changes nothing.
/// Without StrokeSettings::join the sphere must be outside the surface, clear of it, and inside the working volume.
/// With both join and fusion, a solid that crosses the surface becomes part of the model by an exact union.
/// With a mirror, either both the solid and its image are added or neither is. A solid centred on the mirror plane
/// counts as its own image; any other solid must be clear of its image.
/// Precondition: a stroke is open.
void addSolid(DabContext& context);
} // namespace core
