#pragma once

#include "core/mesh/surgery.h"

#include <optional>
#include <span>

namespace core
{
/// Whether the cycle of edges runs around a tunnel: the surface along it faces its middle. Otherwise it runs around the
/// solid, as around a neck. `cycle`: three or more vertices, in either order.
bool isTunnel(const Mesh& mesh, std::span<const Slot> cycle);

/// Cuts a neck, or fills a tunnel, along a cycle of edges: each side gets its own copies of the vertices and a cap,
/// drawn back by half the gap. The copies of the left side come first, in the cycle's order.
/// `cycle`: three or more vertices, in either order. Nothing if the result would not be a closed 2-manifold.
std::optional<Surgery> cutCycle(const Mesh& mesh, std::span<const Slot> cycle, double gap);
} // namespace core
