#pragma once

#include "region.h"

namespace core
{
/// Area-weighted normal of a vertex: an exact sum of products of lattice coordinates, so the order of the faces does not
/// matter. In squared units of the document, not normalised; zero where the star's areas cancel.
Vec3 vertexNormal(const Mesh& mesh, Slot v);

/// Of a face, twice its area long.
Vec3 faceNormal(const Mesh& mesh, Slot f);

/// Plans where the dab moves each vertex of the region (paper, section 3.3). With b = falloff(r_i / R), s = strength:
///   Pull, Push   +-0.1 R s b N_i
///   Flatten      min(s, 1) b ((P_center - p_i) . N_avg) N_avg, of the region's mean point and mean normal
///   Smooth       min(s, 1) b (mean of the neighbours - p_i)
/// r_i is the region's distance. Returns the longest displacement planned. Precondition: not Paint.
double planDeformation(Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab);

/// Of the points around v.
Vec3 neighbourMean(const Mesh& mesh, Slot v);

/// Turns the plans of the region's vertices at and around the given ones towards their neighbours' mean, lengths kept: on a
/// rough surface normals differ so much that neighbours would pass each other, faces turn over. `vertices`: may be gone.
void calmPlan(Region& region, const Mesh& mesh, std::span<const Slot> vertices);
} // namespace core
