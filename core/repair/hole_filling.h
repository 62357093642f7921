#pragma once

#include "core/repair/triangle_soup.h"

#include "core/util/job_control.h"

#include <cstddef>
#include <optional>

namespace core::repair
{
struct HoleFillingResult
{
    std::size_t holes = 0;
    std::size_t faces = 0;       ///< number of faces added
    std::size_t largeHoles = 0;  ///< number of large holes: filled if `largeToo` was true, otherwise left open
    double share = 0;            ///< added area as a share of the area before
    std::optional<Vec3> largest; ///< middle of the box of the largest hole, lattice units; missing if there is none
};

/// Whether new faces may lie on the surface.
enum class Covering {
    Allowed,
    /// If, with the least area, a face folds back at the rim, and at most half of the area would lie on the surface, a
    /// loop of up to 300 corners is filled again: no face has its middle on the surface, and faces in planes of the
    /// loop are preferred. That is kept if it encloses more. So a box without two sides that meet is filled up to its
    /// edge.
    Avoided
};

/// A hole is large if the longest side of its box exceeds this share of the longest side of the surface's box.
inline constexpr double largeHole = 0.25;

/// Closes the loops at which the surface ends with faces of the least total area (Barequet and Sharir 1995). Loops that
/// bound one opening together, as the rims at the end of a pipe do, are filled together, up to 600 corners. A loop
/// consists of edges that faces run along more often in one direction than in the other. Loops of more than 300 corners
/// first lose their most pointed corners. New faces may meet other faces. Precondition: the surface is oriented.
HoleFillingResult fillHoles(TriangleSoup& surface, bool largeToo, Covering covering, const JobControl& control = {});
} // namespace core::repair
