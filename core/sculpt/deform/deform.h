#pragma once

#include "core/sculpt/deform/stroke_displacements.h"
#include "core/sculpt/select/region.h"
#include "core/stroke/stroke.h"

namespace core
{
/// Returns the weight b(x) of a vertex at this distance from the dab's centre, in mm: 1 at the centre, 0 at the rim
/// (paper, section 3.3). x is the distance in radii, n the stroke's falloff.
double weightAt(double distance, const StrokeSettings& settings, const Dab& dab);

/// Returns the normalised sum of the unit normals of the region's vertices, N_avg of the paper (section 3.3); zero if
/// they cancel out.
Vec3 meanNormal(const Region& region, const Mesh& mesh);

/// The input of a tool's field, besides the vertices that it moves.
struct DeformInput
{
    const Mesh& mesh;
    const StrokeSettings& settings;
    const Dab& dab;
    const StrokeDisplacements& displacements; ///< of the stroke so far; Layer needs those of the region filled
};

/// Plans the displacement of each vertex of the region by the tool's field (deform.cpp has one function a field). r_i
/// is the region's distance. The mask scales displacements down. Returns the longest displacement planned, in mm.
/// Precondition: not paintsAttribute(tool).
double planDeformation(Region& region, const DeformInput& input);

/// Turns the plans of the region's vertices at and around the given ones towards their neighbours' mean, and keeps
/// their lengths. On a rough surface normals differ so much that neighbours would pass each other and faces turn over.
/// `vertices`: some may be removed.
void smoothPlan(Region& region, const Mesh& mesh, std::span<const Slot> vertices);
} // namespace core
