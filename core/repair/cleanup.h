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

/// Returns whether any two faces have the same corners.
bool hasDoubles(const TriangleSoup& surface);

/// Merges corners of these faces that are within `tolerance` (lattice units) of each other. Faces with a lower height
/// pass their middle corner to the face across their longest side. Then calls cleanUp() with Cancel. Moves the surface
/// by about the tolerance; a closed surface stays closed. Points keep their indices. Returns false if nothing changed.
bool removeSlivers(TriangleSoup& surface, std::span<const Slot> faces, double tolerance);
} // namespace core::repair
