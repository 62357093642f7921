#pragma once

#include "core/repair/triangle_soup.h"

#include "core/util/job_control.h"

#include <cstddef>
#include <vector>

namespace core::repair
{
struct OrientationResult
{
    std::size_t turned = 0;          ///< faces
    std::vector<Triangle> membranes; ///< faces of sheets between others that nobody sees from outside: they went
};

/// Faces joined by edges of two run the same way as most of them did. Parts that hang on edges of three or more and are
/// open are turned to where they are seen from, along the axes; those that are not seen at all go, unless they are
/// walls of a void.
OrientationResult orient(TriangleSoup& surface);

struct OutwardResult
{
    std::size_t turned = 0; ///< parts that faced inwards and lie in no other
    std::size_t inner = 0;  ///< parts that lie inside others and face outwards, and so will be filled; or were turned
    double cavitiesOutside = 0; ///< lattice units^3, about at most, that cavities wind around outside of the solid
};

/// Turns closed parts outwards; open ones stay as they are. Parts inside of others, or flush with them, keep their way:
/// inwards, they are cavities, also where they break through the wall with less than 0.4 of their area. Those in a
/// part that faced inwards are turned with it: the whole was inside out. With `innerAreCavities` parts inside of others
/// that face outwards are turned as well.
OutwardResult orientOutwards(TriangleSoup& surface, bool innerAreCavities);
} // namespace core::repair
