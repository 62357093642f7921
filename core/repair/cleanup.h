#pragma once

#include "core/repair/triangle_soup.h"

#include <cstddef>
#include <span>

namespace core::repair
{
/// Equal points become one, the first of them; points that no face uses go. Returns how many points went because they
/// were equal.
std::size_t weld(TriangleSoup& surface);

enum class Duplicates {
    KeepOne, ///< of faces with the same corners, however they run
    Cancel   ///< faces that run opposite ways take each other away
};

struct CleanupResult
{
    std::size_t degenerate = 0; ///< faces without area
    std::size_t duplicates = 0; ///< faces that went because of others with the same corners
};

/// Afterwards no face is degenerate and there are no duplicates (with Cancel: none that run opposite ways). The surface
/// stays where it is: a face whose corners lie on a line gives the middle one to the face across its long side, and two
/// corners of a face that are equal become one.
CleanupResult cleanUp(TriangleSoup& surface, Duplicates duplicates);

/// Returns whether two faces have the same corners.
bool hasDoubles(const TriangleSoup& surface);

/// Corners of these faces within `tolerance` (lattice units) of each other become one, those of the faces that are
/// lower than that give their middle corner away as above, and all is cleaned up with Cancel. Moves the surface by
/// about the tolerance; what was closed stays closed. Points keep their indices. False: nothing was to do.
bool removeSlivers(TriangleSoup& surface, std::span<const Slot> faces, double tolerance);
} // namespace core::repair
