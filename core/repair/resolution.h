#pragma once

#include "core/repair/winding_solid.h"

#include "core/util/job_control.h"

#include <optional>

namespace core::repair
{
struct Resolution
{
    bool isDone = false;                    ///< no faces meet, and all contacts are separated
    std::optional<LatticePoint> unresolved; ///< a place where faces still meet or touch
    double volume = 0;                      ///< volume that the surface winds around, lattice units^3
    double insideOutVolume = 0;             ///< volume that the surface winds around inside out, lattice units^3
    std::uint64_t intersections = 0;        ///< pairs of faces that met before the first cut
    std::size_t rounds = 0;                 ///< number of times that the surface was cut
    std::size_t touchingEdges = 0, touchingVertices = 0;
    std::size_t knots = 0;  ///< places where faces kept meeting; each is covered by a small solid
    double widestKnot = 0;  ///< diameter of the largest of these solids, lattice units
    std::size_t crumbs = 0; ///< small thin components that were dropped
};

/// Makes a closed surface free of intersections. Cuts it along all of them, keeps the boundary of the solid space,
/// rounds it to the lattice, and repeats while rounding makes faces meet. Where it does: points and slivers within a
/// growing tolerance are merged, and the remaining faces are offset outwards by it, so that sheets that coincide within
/// rounding clearly overlap. After a few rounds, remaining knots narrower than 1/500 of the size are covered by small
/// solids. Parts that touch at edges and vertices are then separated or joined. Last, crumbs are dropped: components
/// less than 64 units thick and with less than 1/10,000 of the area, and those as thin as rounding errors if they have
/// less than 1/50 of it together. Away from these places no point moves. Uses all cores. A tangle in which more than
/// 1,000,000 triples of faces meet each other stays unresolved: it would take more than a minute. A surface also stays
/// unresolved if more than 100,000 pairs of faces meet after contacts were moved apart. `cavities`: parts that face
/// inwards (winding_solid.h). `tolerance`: accuracy of the surface's points, lattice units; nearer points of faces that
/// meet are merged. `budget`: number of pairs of faces that may be cut after the first time, about 5,000 a second. It
/// is reduced by what was cut; when it is spent, the surface stays unresolved.
Resolution resolveIntersections(TriangleSoup& surface, Inside inside, const TriangleSoup& cavities, double tolerance,
                                std::uint64_t& budget, const JobControl& control = {});

/// Faces of a closed surface that are not in a part of it. Precondition: no face of the part meets them.
struct LeftOut
{
    WindingNumber kept;    ///< faces that bound the solid space
    WindingNumber dropped; ///< faces that do not bound it
};

/// Cuts a part of a surface as resolveIntersections() does, but does not separate contacts. Precondition: the borders
/// of the part are away from faces that meet. isDone: no faces of the part meet. `tolerance`: 0 or more, lattice units.
/// With 0, points move only by rounding, and after six rounds the part stays unresolved.
Resolution cutIntersections(TriangleSoup& part, Inside inside, const LeftOut& leftOut, double tolerance,
                            std::uint64_t& budget, const JobControl& control = {});
} // namespace core::repair
