#pragma once

#include "core/geometry/geometry.h"

#include <cstdint>
#include <vector>

namespace core
{
/// The vertices that the next dab would select, before it refines the mesh, and what share of it reaches each.
struct Footprint
{
    /// A brush that holds more is not searched to its end.
    static constexpr Slot maxSlots = 1 << 15;

    std::vector<Slot> slots;           ///< one that the dab and images of it select stands as often
    std::vector<std::uint8_t> weights; ///< of each slot b(x) x 255, at least 1
};
} // namespace core
