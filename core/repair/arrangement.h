#pragma once

#include "core/repair/triangle_soup.h"

#include "core/analysis/self_intersection.h"
#include "core/util/job_control.h"

#include <span>

namespace core::repair
{
/// A piece of a face between the lines along which others meet it.
struct ArrangedFace
{
    Triangle corners; ///< of Arrangement
    Slot original;    ///< the face of the surface
    int jump = 1; ///< the winding number behind it less the one before it: 1, but for faces that lay upon each other
};

/// The surface cut along its own intersections: pieces meet at common corners and edges only. Where faces of one plane
/// lay upon each other there is one piece, or none if they cancel.
struct Arrangement
{
    std::vector<Vec3> points; ///< lattice units; the surface's own first, then the new ones, to the nearest doubles
    std::vector<Rgb> colors;  ///< as in Surface
    std::vector<ArrangedFace> faces;
    /// Of faces that others of the same plane covered: those others, ascending. By original face; most are empty.
    std::vector<std::vector<Slot>> upon;
};

/// Exact (after Zhou, Grinspun, Zorin and Jacobson 2016, "Mesh arrangements for solid geometry"). `pairs` are all the
/// pairs of faces that meet. No two points are equal, no face is degenerate. All cores; cost grows with the square of
/// what meets one face. If it is cancelled, the result is not usable.
Arrangement arrange(const TriangleSoup& surface, std::span<const FacePair> pairs, const JobControl& control = {});
} // namespace core::repair
