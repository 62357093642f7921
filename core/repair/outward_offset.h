#pragma once

#include "core/repair/triangle_soup.h"

#include <span>

namespace core::repair
{
/// Moves each of these points outwards, so that the planes of its faces move by about `distance` (lattice units), or by
/// 1.5 or 2 times that, depending on its component. Overlapping sheets of two components thus mostly separate. The
/// displacement has the least squared error in the planes' distances (Garland and Heckbert 1997). It is at most three
/// times the wanted distance and a quarter of the point's shortest edge. Faces that coincided within rounding then
/// clearly overlap. Cost: O(faces).
void offsetOutwards(TriangleSoup& surface, std::span<const Slot> points, double distance);
} // namespace core::repair
