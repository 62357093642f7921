#pragma once

#include "core/repair/triangle_soup.h"

#include <vector>

namespace core::repair
{
/// Removes all but one of the parts that coincide within 16 lattice units although their triangles differ. Complements
/// Duplicates::KeepOne: a shell that exists twice loses its common faces to that, and the rest to this function. Parts
/// are connected by edges of two faces; these parts are open and have the same border of edges of three or more faces,
/// in either orientation. Returns the removed faces. Cost: one sort, and the distances between parts with the same
/// border.
std::vector<Triangle> dropDoubledPatches(TriangleSoup& surface);

/// Removes all but one of the closed parts that coincide within 16 lattice units and face the same way: a solid or
/// cavity that exists twice counts once. Precondition: the two faces of an edge run along it in opposite directions.
/// Returns the removed faces. Cost: one sort, and the distances between parts of equal size and place.
std::vector<Triangle> dropDoubledShells(TriangleSoup& surface);
} // namespace core::repair
