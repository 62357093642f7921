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
    std::size_t turned = 0;     ///< parts that faced inwards and are no cavities
    std::size_t inner = 0;      ///< parts inside of others that are no cavities by the way they run
    bool isGuess = false;       ///< some, in parts of the other way by 0.4 or more, were taken for no cavities
    double cavitiesOutside = 0; ///< lattice units^3 that cavities wind around outside of the solid, or twice, roughly
};

/// Turns closed parts outwards but for cavities; open ones stay as they are. A cavity faces inwards, and parts that
/// face outwards wind around more than 0.6 of its area (by their winding numbers; it may cross other cavities, and
/// break out of the wall); or it faces outwards, and lies wholly in a part that faces inwards: the whole was inside
/// out, and it is turned with that. With `innerAreCavities` other parts inside of others face inwards as well.
OutwardResult orientOutwards(TriangleSoup& surface, bool innerAreCavities);
} // namespace core::repair
