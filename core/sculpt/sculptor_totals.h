#pragma once

#include <array>
#include <cstdint>

namespace core
{
/// Numbers of operations that a Sculptor has performed since it was constructed.
struct SculptorTotals
{
    std::uint64_t splits = 0, collapses = 0, flips = 0, fusions = 0, separations = 0, rolledBack = 0;
    std::array<std::uint64_t, 3> verifyTiers{}; ///< successful verifications, indexed by VerifyTier
};
} // namespace core
