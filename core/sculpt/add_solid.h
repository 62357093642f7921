#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// Whether the dab is to add a solid: the stroke asks for that, and nothing is under the brush, or it may join.
/// `region`: what the dab selects.
bool wantsSolid(const VerifiedMesh& surface, const StrokeSettings& settings, const Dab& dab, const Region& region);

/// Returns why spheres of that radius may not be added at these places together, if so. Equal places count once.
Refusal refusalOf(const VerifiedMesh& surface, const std::vector<Vec3>& centers, double radius);

/// Adds a sphere of the dab's radius, or the brush's model in it, upright (free topology: paper, section 3.5.1), and
/// notes in the context's report what came of it. Without StrokeSettings::join the sphere must lie outside the surface,
/// clear of it, and inside the working volume; with it and fusion one that crosses the surface becomes part of the
/// model by an exact union. A solid that is refused changes nothing. With a mirror the image is added, too, or neither
/// is. A solid whose centre is on the mirror's plane counts as its own image, another must be clear of its image.
/// Precondition: a stroke is open.
void addSolid(DabContext& context);
} // namespace core
