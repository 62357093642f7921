#pragma once

#include "region.h"

namespace core
{
/// Area-weighted normal of a vertex from its lattice coordinates: an exact integer sum, so the order of the faces does not
/// matter. Not normalised; zero where the star's areas cancel.
Vec3 vertexNormal(const Mesh& mesh, Slot v);

/// Plans where the dab moves each vertex of the region (paper, section 3.3). With b = falloff(r_i / R), s = strength:
///   Pull, Push   +-0.1 R s b N_i
///   Smooth       min(s, 1) b (mean of the neighbours - p_i)
/// Returns the longest displacement planned.
double planDeformation(Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab);
} // namespace core
