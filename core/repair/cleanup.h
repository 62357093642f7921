#pragma once

#include "core/repair/triangle_soup.h"

#include <cstddef>

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
/// stays where it is: a face whose corners lie on a line gives the middle one to the face across its long side. Points
/// are welded.
CleanupResult cleanUp(TriangleSoup& surface, Duplicates duplicates);
} // namespace core::repair
