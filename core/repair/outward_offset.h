#pragma once

#include "core/repair/triangle_soup.h"

#include <span>
#include <stop_token>

namespace core::repair
{
/// Moves each of these points outwards, so that the planes of its faces move by about `distance` (lattice
/// units), or by 1.5 or 2 times that, depending on its component. Overlapping sheets of two
/// components thus mostly separate. The displacement has the least squared error in the planes' distances (Garland and
/// Heckbert 1997). It is at most three times the wanted distance and a quarter of the point's shortest edge. Faces that
/// coincided within rounding then clearly overlap. Cost: O(faces).
void offsetOutwards(TriangleSoup& surface, std::span<const Slot> points, double distance);

struct ContactOffset
{
    std::size_t pairs = 0;     ///< pairs of faces that were in contact
    double addedVolume = 0;    ///< what bodies gained where their moved faces are visible, lattice units^3
    double invertedVolume = 0; ///< what sheets without thickness enclose now, inside out, lattice units^3
};

/// Offsets walls that coincide within rounding but are not coplanar, such as those of two bodies on each other after a
/// turn. Two faces are in contact if they face opposite ways and are within 2 lattice units of each other. If there is
/// solid space 16 units beyond both, they are offset outwards by 6 to 12 units, so that the bodies overlap; a face that
/// others cover much less than it covers them stays. If there is nothing 4 units beyond either, they are the sides of a
/// sheet without thickness: they are offset inwards by 4 to 8 units, so that it is inside out. Corners of these faces
/// move up to three times as far. Does nothing if there are more than four pairs for each face: such stacks of sheets
/// enclose nothing clear. Cost: a tree of the faces, a test for each pair of faces whose boxes meet, and a
/// WindingNumber and some of its queries for each pair in contact; on all cores.
ContactOffset offsetContacts(TriangleSoup& surface, const std::stop_token& stop = {});
} // namespace core::repair
