#pragma once

#include <array>
#include <cstdint>

namespace core
{
/// Operations that a sculptor has done since it was made.
struct SculptorTotals
{
    std::uint64_t splits = 0, collapses = 0, flips = 0, fusions = 0, separations = 0, rolledBack = 0;
    std::array<std::uint64_t, 3> verifyTiers{}; ///< sub-steps proved by patch certificate, by stars, by pairs
};
} // namespace core
