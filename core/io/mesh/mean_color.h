#pragma once

#include "core/geometry/geometry.h"

namespace core::io
{
/// Computes the mean of added colours; Rgb() if there are none.
struct MeanColor
{
    std::array<std::uint32_t, 3> sum{};
    std::uint32_t count = 0;

    void add(const Rgb& color)
    {
        sum[0] += color.r;
        sum[1] += color.g;
        sum[2] += color.b;
        ++count;
    }
    Rgb color() const
    {
        const auto mean = [this](std::size_t i) { return static_cast<std::uint8_t>((sum[i] + count / 2) / count); };
        return count == 0 ? Rgb() : Rgb{mean(0), mean(1), mean(2)};
    }
};
} // namespace core::io
