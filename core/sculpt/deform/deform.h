#pragma once

#include "core/sculpt/deform/stroke_displacements.h"
#include "core/sculpt/select/region.h"
#include "core/stroke/stroke.h"

namespace core
{
/// Returns the weight b(x) at this distance (mm) from the dab's centre: 1 at the centre, 0 at the rim (paper, section
/// 3.3). x is the distance in radii, n the stroke's falloff.
double weightAt(double distance, const StrokeSettings& settings, const Dab& dab);

/// Returns the mean normal of the region: the normalised sum of its vertices' unit normals (N_avg in the paper, section
/// 3.3). Returns zero if they cancel out.
Vec3 meanNormal(const Region& region, const Mesh& mesh);

/// The input of a tool's displacement field, except the vertices that it moves.
struct DeformInput
{
    const Mesh& mesh;
    const StrokeSettings& settings;
    const Dab& dab;
    /// displacements by the stroke so far; for Layer, fill() must have been called for the region
    const StrokeDisplacements& displacements;
    Vec3 moved = Vec3::Zero(); ///< Grab: the motion of the stroke so far, mm
};

/// Plans the displacement of each vertex of the region by the tool's field (see the functions in deform.cpp). The
/// distance r_i of a vertex is the region's. Masks reduce displacements. Returns the longest displacement planned, in
/// mm. Precondition: not paintsAttribute(tool).
double planDeformation(Region& region, const DeformInput& input);

/// Turns the planned displacements of the given vertices and their neighbours towards the mean of their neighbours'
/// plans, and keeps their lengths. On a rough surface, normals differ so much that neighbours would otherwise pass each
/// other and faces would turn over. `vertices`: some may have been removed.
void smoothPlan(Region& region, const Mesh& mesh, std::span<const Slot> vertices);
} // namespace core
