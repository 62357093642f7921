#pragma once

#include "core/mesh/surgery.h"

#include <optional>
#include <span>

namespace core
{
/// Returns whether the cycle of edges runs around a tunnel and not around a part of the solid, such as a neck. Around a
/// tunnel, the direction from most edges to the cycle's middle leads out of the solid. `cycle`: three or more vertices,
/// in either order.
bool isTunnel(const Mesh& mesh, std::span<const Slot> cycle);

/// The direction in which the two sides of a cut are moved apart. AlongAxis: along the cycle's axis, for a neck, whose
/// cycle is nearly planar. AlongSurface: each vertex within its own surface, for any cycle.
enum class DrawBack { AlongAxis, AlongSurface };

/// Cuts a neck, or fills a tunnel, along a cycle of edges. Each side gets its own copies of the vertices and a cap, and
/// is moved back by half of `gap` (mm). The first copies belong to the left side, in the cycle's order. `cycle`: three
/// or more vertices, in either order. Returns nothing if the result would not be a closed 2-manifold.
std::optional<Surgery> cutCycle(const Mesh& mesh, std::span<const Slot> cycle, DrawBack along, double gap);
} // namespace core
