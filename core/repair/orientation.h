#pragma once

#include "core/repair/triangle_soup.h"

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
    std::size_t turned = 0;         ///< parts that faced inwards and face outwards now
    std::size_t inner = 0;          ///< parts inside of others that are no cavities by the way they run
    std::vector<Triangle> cavities; ///< faces of parts that face inwards now
    /// Faces of parts that are taken for no cavities, though more than 0.001 of the area of each lies in parts of the
    /// other way. Of a part with more than half of the volume of all it is more than 0.02 if that faces inwards, else
    /// more than 0.2.
    std::vector<Slot> guesses;
};

/// Turns closed parts outwards but for cavities; open ones stay as they are. A cavity faces inwards, and parts that
/// face outwards wind around more than 0.6 of its area, by their winding numbers, more often than others that face
/// inwards wind around all of it (it may cross other cavities, and break out of the wall); or it faces outwards, and
/// all of it lies in a part that faces inwards and is no cavity: the whole was inside out, and it is turned with that.
/// Parts in a cavity stay as they are. With `innerAreCavities` other parts inside of others face inwards as well. All
/// cores. Cost: a sort, and some 10 to 15 ms for each part whose box meets that of another one; some 60 ms for one that
/// faces inwards and lies partly in others, up to half a second within another that faces inwards.
OutwardResult orientOutwards(TriangleSoup& surface, bool innerAreCavities);
} // namespace core::repair
