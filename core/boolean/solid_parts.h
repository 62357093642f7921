#pragma once

#include "core/boolean/solid_soup.h"

namespace core::boolean
{
/// The outcome for a face.
enum class Fate : std::uint8_t {
    Cut,    ///< another solid meets it
    Kept,   ///< it bounds the result
    Dropped ///< it does not bound the result
};

/// Returns the fate of each face. `crossing`: the faces that other solids meet, ascending. The remaining faces form
/// parts connected by vertices; each part is entirely inside or outside each other solid. One vertex of each part is
/// tested exactly, by the parity of the faces above it. Cost: one pass over the faces, and one over each solid whose
/// box contains the vertex; with many parts, a tree of the solid's boxes.
std::vector<Fate> fatesOf(const SolidSoup& soup, std::span<const Slot> crossing);
} // namespace core::boolean
