#pragma once

#include "core/repair/triangle_soup.h"

#include "core/analysis/self_intersection.h"
#include "core/util/job_control.h"

#include <span>

namespace core::repair
{
/// A piece of a face, cut along the lines at which other faces meet it.
struct ArrangedFace
{
    Triangle corners; ///< indices into Arrangement::points
    Slot original;    ///< the face of the surface that it is a piece of
    /// The winding number behind the piece minus the one in front of it: 1, or another number where faces of one plane
    /// overlapped.
    int jump = 1;
};

/// The surface cut along its own intersections: pieces meet only at common corners and edges. Where faces of one plane
/// overlapped, one piece remains, or none if they cancel.
struct Arrangement
{
    std::vector<Vec3> points; ///< in lattice units: the surface's own points, then the new ones as the nearest doubles
    std::vector<Rgb> colors;  ///< one per point, or empty if the surface has none
    std::vector<ArrangedFace> faces;
    /// Faces, for each original face, of the same plane that overlapped it, ascending; empty for most.
    std::vector<std::vector<Slot>> upon;
};

/// Cuts a surface along its intersections, exactly (after Zhou, Grinspun, Zorin and Jacobson 2016, "Mesh arrangements
/// for solid geometry"). Precondition: `pairs` contains all pairs of faces that meet, no two points are equal, and no
/// face is degenerate. Uses all cores. Cost: quadratic in the number of faces that meet one face. The result of a
/// cancelled call must not be used.
Arrangement arrange(const TriangleSoup& surface, std::span<const FacePair> pairs, const JobControl& control = {});
} // namespace core::repair
