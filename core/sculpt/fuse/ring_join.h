#pragma once

#include "core/sculpt/fuse/ring_strip.h"

#include <optional>

namespace core
{
/// Joins the neighbourhoods of two vertices (paper, section 3.4, Figure 13): both stars go, and their 1-rings are
/// connected by a strip of triangles. Rings with common vertices are connected arc by arc. Returns nothing if the rings
/// do not fit together, if the result would not be a closed 2-manifold, or if their component has no other faces. Does
/// not check whether faces meet then. Precondition: p and q are live and not neighbours.
std::optional<Surgery> joinStars(const Mesh& mesh, Slot p, Slot q, Stepping stepping = Stepping::Even);

/// Cuts a neck along the three edges between pairwise neighbours that are no face (a failed link condition finds them):
/// each side gets its own copies of the vertices and a cap, drawn back by half the gap along the neck's axis. `cycle`:
/// in either order. Nothing if the result would not be a closed 2-manifold.
std::optional<Surgery> cutNeck(const Mesh& mesh, const Triangle& cycle, double gap);
} // namespace core
