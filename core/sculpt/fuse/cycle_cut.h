#pragma once

#include "core/mesh/surgery.h"

#include <optional>
#include <span>

namespace core
{
/// Returns whether the cycle of edges runs around a tunnel: its middle lies outside of the solid, as most of the edges
/// see it between their two faces. Otherwise it runs around the solid, as around a neck. `cycle`: three or more
/// vertices, in either order.
bool isTunnel(const Mesh& mesh, std::span<const Slot> cycle);

/// The direction in which the two sides of a cut are drawn back. AlongAxis: the cycle's; for a neck, which is nearly
/// plane. AlongSurface: each vertex along its own surface; for any cycle.
enum class DrawBack { AlongAxis, AlongSurface };

/// Cuts a neck, or fills a tunnel, along a cycle of edges: each side gets its own copies of the vertices and a cap,
/// drawn back by half the gap. The copies of the left side come first, in the cycle's order. `cycle`: three or more
/// vertices, in either order. Returns nothing if the result would not be a closed 2-manifold.
std::optional<Surgery> cutCycle(const Mesh& mesh, std::span<const Slot> cycle, DrawBack along, double gap);
} // namespace core
