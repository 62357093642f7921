#pragma once

#include "core/repair/triangle_soup.h"

#include <cstddef>
#include <span>

namespace core::repair
{
/// Merges equal points into the first of them and removes points that no face uses. Returns the number of points that
/// were merged into others.
std::size_t weld(TriangleSoup& surface);

enum class Duplicates {
    KeepOne, ///< keeps one of the faces with the same corners, in any order
    Cancel   ///< removes pairs of faces with the same corners in opposite orientations
};

struct CleanupResult
{
    std::size_t degenerate = 0; ///< faces without area
    std::size_t duplicates = 0; ///< faces removed because others have the same corners
};

/// Removes degenerate faces and duplicates; with Cancel, only duplicates of opposite orientation. The shape does not
/// change. A face with collinear corners passes its middle corner to the face across its longest side. Two equal
/// corners of a face are merged.
CleanupResult cleanUp(TriangleSoup& surface, Duplicates duplicates);

/// Returns whether two faces have the same corners.
bool hasDoubles(const TriangleSoup& surface);

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

/// Merges corners of these faces that are within `tolerance` (lattice units) of each other. Faces with a lower height
/// pass their middle corner to the face across their longest side. Then calls cleanUp() with Cancel. Moves the surface
/// by about the tolerance; a closed surface stays closed. Points keep their indices. Returns false if nothing changed.
bool removeSlivers(TriangleSoup& surface, std::span<const Slot> faces, double tolerance);
} // namespace core::repair
