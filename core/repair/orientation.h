#pragma once

#include "core/repair/triangle_soup.h"

#include <cstddef>
#include <vector>

namespace core::repair
{
struct OrientationResult
{
    std::size_t turned = 0; ///< number of faces whose orientation was reversed
    /// Removed faces: open parts between other faces that are not visible from outside.
    std::vector<Triangle> membranes;
};

/// Orients faces that are joined by edges of two faces like the majority of their part. Open parts that have edges of
/// three or more faces are turned towards the side from which they are visible, along the axes. Invisible ones are
/// removed, unless they are walls of a void. Visible faces that become neighbours by this are not turned to agree;
/// otherwise the walls of a column that is there twice would cancel each other.
OrientationResult orient(TriangleSoup& surface);

struct OutwardResult
{
    std::size_t turned = 0;         ///< number of parts that faced inwards and now face outwards
    std::size_t inner = 0;          ///< number of parts inside others that are no cavities by their orientation
    std::vector<Triangle> cavities; ///< faces of the parts that now face inwards
    /// Faces of parts that were not taken for cavities, although more than the share 0.001 of the part's area is inside
    /// parts of the other orientation. For a part with more than half of the total volume the share is 0.02 if it faces
    /// inwards, otherwise 0.2.
    std::vector<Slot> guesses;
};

/// Turns closed parts outwards, except cavities; open parts stay as they are. A part is a cavity in two cases:
///   - It faces inwards, and outward parts wind around more than 0.6 of its area, by their winding numbers, more often
///     than other inward parts wind around all of it. It may cross other cavities and break out of the wall.
///   - It faces outwards, and all of it is in a part that faces inwards and is no cavity. The whole was inside out, and
///     both are turned.
/// Parts in a cavity stay as they are. `innerAreCavities`: other parts inside parts are turned inwards too. Uses all
/// cores. Cost: one sort, and 10 to 15 ms for each part whose box meets that of another part. A part that faces inwards
/// and is partly in others costs about 60 ms, or up to half a second inside another inward part.
OutwardResult orientOutwards(TriangleSoup& surface, bool innerAreCavities);
} // namespace core::repair
