#pragma once

#include "core/sculpt/fuse/ring_strip.h"

#include <optional>

namespace core
{
/// Joins the neighbourhoods of two vertices (paper, section 3.4, Figure 13). Both stars are removed, and their 1-rings
/// are connected by a strip of triangles. Rings with common vertices are connected arc by arc. Returns nothing if the
/// common vertices are in different orders, if the result would not be a closed 2-manifold, or if the component has no
/// other faces. Does not check for intersections. Precondition: p and q are live and not neighbours.
std::optional<Surgery> joinStars(const Mesh& mesh, Slot p, Slot q, Stepping stepping = Stepping::Even);
} // namespace core
