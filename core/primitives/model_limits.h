#pragma once

#include <cstddef>

namespace core
{
/// Limits of a document.
struct ModelLimits
{
    /// limits of the largest magnitude of a coordinate, in the document's unit
    static constexpr double minExtent = 1e-6, maxExtent = 1e7;
    static constexpr std::size_t maxFaces = 20'000'000; ///< largest number of faces that a remeshing may aim at
};
} // namespace core
