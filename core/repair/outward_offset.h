#pragma once

#include "core/repair/triangle_soup.h"

#include <span>

namespace core::repair
{
/// Moves each of these points outwards so far that the planes of its faces move by about `distance` (lattice units), or
/// by half or the whole of it more: by the component that it belongs to, so that sheets of two components that lay upon
/// each other mostly part. No point moves by more than three times that, nor by more than a quarter of its shortest
/// edge. The displacement with the least squared error in the planes' distances (Garland and Heckbert 1997). Faces that
/// faced each other within rounding then clearly overlap. Linear in the faces.
void offsetOutwards(TriangleSoup& surface, std::span<const Slot> points, double distance);
} // namespace core::repair
