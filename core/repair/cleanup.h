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

/// Drops all but one of the parts that lie upon each other within 16 lattice units and are triangulated otherwise, as
/// the faces do that Duplicates::KeepOne drops: a shell that is there twice loses what both copies share to that, and
/// the rest to this. Parts hang together by edges of two, and these are not closed and end at the same edges of
/// three or more; they may run either way. Returns the faces that went. Cost: a sort, and the distances between parts
/// that end at the same edges.
std::vector<Triangle> dropDoubledPatches(TriangleSoup& surface);

/// Drops all but one of the closed parts that lie upon each other within 16 lattice units and face the same way: a body
/// or a cavity that is there twice counts as one. Faces run opposite ways along edges of two. Returns the faces that
/// went. Cost: a sort, and the distances between parts of one size at one place.
std::vector<Triangle> dropDoubledShells(TriangleSoup& surface);

/// Corners of these faces within `tolerance` (lattice units) of each other become one, those of the faces that are
/// lower than that give their middle corner away as above, and all is cleaned up with Cancel. Moves the surface by
/// about the tolerance; what was closed stays closed. Points keep their indices. False: nothing was to do.
bool removeSlivers(TriangleSoup& surface, std::span<const Slot> faces, double tolerance);
} // namespace core::repair
