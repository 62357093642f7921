#pragma once

#include "core/geometry/geometry.h"

#include <cstdint>
#include <vector>

namespace core
{
/// The vertices that the next dab would select, before it refines the mesh, and the dab's weight at each.
struct Footprint
{
    /// Largest number of vertices; the search stops at this number.
    static constexpr Slot maxSlots = 1 << 15;

    /// Selected vertices; a vertex selected by several symmetric images of the dab is repeated.
    std::vector<Slot> slots;
    /// Weight of each vertex in `slots`, from 1 (no effect) to 255 (full effect). Falloff, alpha and mask reduce it.
    std::vector<std::uint8_t> weights;
};
} // namespace core
