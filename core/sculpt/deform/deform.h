#pragma once

#include "core/sculpt/select/region.h"

namespace core
{
/// The dab's share of a vertex at that distance: 1 in the middle, 0 at the rim; n of b(x) is the stroke's falloff
/// (paper, section 3.3).
double weightAt(double distance, const StrokeSettings& settings, const Dab& dab);

/// Unit length, or zero: of the region's vertices, each counted once.
Vec3 meanNormal(const Region& region, const Mesh& mesh);

/// Plans where the dab moves each vertex of the region, by its tool's field: fields stand in deform.cpp, a line each.
/// r_i is the region's distance; what the mask holds back is left out. Returns the longest displacement planned.
/// Precondition: not paintsAttribute(tool).
double planDeformation(Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab);

/// Turns the plans of the region's vertices at and around the given ones towards their neighbours' mean, lengths kept:
/// on a rough surface normals differ so much that neighbours would pass each other, faces turn over. `vertices`: may be
/// gone.
void smoothPlan(Region& region, const Mesh& mesh, std::span<const Slot> vertices);
} // namespace core
