#pragma once

#include "core/repair/winding_solid.h"

#include "core/util/job_control.h"

#include <optional>

namespace core::repair
{
struct Resolution
{
    bool isDone = false;                    ///< no faces meet, and no points are stuck
    std::optional<LatticePoint> unresolved; ///< where faces still meet or touch
    double volume = 0;                      ///< lattice units^3, of all that the surface winds around
    double insideOutVolume = 0;             ///< lattice units^3, of all that it winds around inside out
    std::uint64_t intersections = 0;        ///< pairs of faces that met at first
    std::size_t rounds = 0;                 ///< of cutting
    std::size_t touchingEdges = 0, touchingVertices = 0;
    std::size_t knots = 0;  ///< places where faces met again and again: a small solid covers each
    double widestKnot = 0;  ///< the diameter of the largest of these, lattice units
    std::size_t crumbs = 0; ///< small thin components that were dropped
};

/// Cuts the surface along all of its intersections, keeps the boundary of what counts as solid, rounds that to the
/// lattice, and again while rounding makes faces meet; where it does so, points and slivers within a tolerance that
/// grows go, and what is left of these faces is offset outwards by it, so that sheets that lie upon each other but for
/// rounding overlap clearly. Knots that are left after a few rounds are covered by small solids, where they are less
/// than 1/500 of the size wide. Parts that touch at edges and vertices are then separated or joined, and crumbs that
/// all this left, less than 64 units thick and with less than 1/10,000 of the area, are dropped. The surface is closed.
/// Away from these places no point moves. `cavities`: parts that face inwards (winding_solid.h). All cores.
/// A tangle in which over 1,000,000 triples of faces meet each other remains unresolved: it would take a minute and
/// more. `tolerance`: in lattice units, what the surface's own places are good for: points of faces that meet and lie
/// closer become one. `budget`: of pairs of faces that may be cut after the first time, some 5,000 a second; what was
/// cut is taken from it, and where it is spent the surface remains unresolved.
Resolution resolveIntersections(TriangleSoup& surface, Inside inside, const TriangleSoup& cavities, double tolerance,
                                std::uint64_t& budget, const JobControl& control = {});
} // namespace core::repair
