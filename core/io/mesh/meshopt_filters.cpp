// Source: KHR_meshopt_compression, appendix B. All filters except Color are also those of EXT_meshopt_compression.
#include "core/io/mesh/binary.h"
#include "core/io/mesh/meshopt.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace core::io
{
namespace
{
template <class Number> std::array<Number, 4> fourAt(const char* at)
{
    std::array<Number, 4> four{};
    for (std::size_t i = 0; i < 4; ++i)
        four[i] = load<Number>(at + i * sizeof(Number), std::endian::little);
    return four;
}

/// Stores a number rounded and clamped to its type. Damaged data may produce numbers that are too large or NaN; NaN and
/// infinity are stored as 0.
template <class Number> void storeRounded(double value, char* at)
{
    constexpr double min = std::numeric_limits<Number>::min(), max = std::numeric_limits<Number>::max();
    const auto rounded = std::isfinite(value) ? static_cast<Number>(std::clamp(std::round(value), min, max)) : Number();
    store(at, rounded);
}

/// Decodes a unit vector from two octahedral coordinates. The third input is the value of 1 in their precision; the
/// fourth is unchanged. All are signed and normalised.
template <class Number> void filterOctahedral(char* at)
{
    const auto in = fourAt<Number>(at);
    const double one = in[2];
    double x = in[0] / one, y = in[1] / one;
    const double z = 1 - std::abs(x) - std::abs(y), below = std::min(z, 0.0);
    x -= std::copysign(below, x);
    y -= std::copysign(below, y);
    const double scale = std::numeric_limits<Number>::max() / std::sqrt(x * x + y * y + z * z);
    storeRounded<Number>(x * scale, at);
    storeRounded<Number>(y * scale, at + sizeof(Number));
    storeRounded<Number>(z * scale, at + 2 * sizeof(Number));
}

/// Decodes a unit quaternion from its three smaller components, multiplied by the square root of 2. The fourth input is
/// the value of 1 in their precision; its two lowest bits are the index of the largest component.
void filterQuaternion(char* at)
{
    const auto in = fourAt<std::int16_t>(at);
    const double one = in[3] | 3, range = std::sqrt(0.5);
    const double x = in[0] / one * range, y = in[1] / one * range, z = in[2] / one * range;
    const double w = std::sqrt(std::max(0.0, 1 - x * x - y * y - z * z));
    std::size_t place = static_cast<unsigned>(in[3]) & 3; // index of the largest component
    for (const double component : {w, x, y, z})
        storeRounded<std::int16_t>(component * 32767, at + 2 * (place++ % 4));
}

/// Decodes a float from a signed 8-bit exponent in the high bits and a signed 24-bit mantissa.
void filterExponential(char* at)
{
    const auto bits = load<std::int32_t>(at, std::endian::little);
    const std::int32_t exponent = bits >> 24,
                       mantissa = static_cast<std::int32_t>(static_cast<std::uint32_t>(bits) << 8) >> 8;
    store(at, static_cast<float>(std::ldexp(static_cast<double>(mantissa), exponent)));
}

/// Converts luma and two chroma values to red, green and blue. The fourth value has the alpha below a bit that marks
/// the precision.
template <class Number> void filterColor(char* at)
{
    const auto in = fourAt<std::make_signed_t<Number>>(at);
    const auto alpha = static_cast<Number>(in[3]), luma = static_cast<Number>(in[0]);
    const double one = std::pow(2.0, std::bit_width(alpha)) - 1, scale = std::numeric_limits<Number>::max() / one;
    const unsigned withoutMark = alpha & (static_cast<unsigned>(one) >> 1);
    storeRounded<Number>((luma + in[1] - in[2]) * scale, at);
    storeRounded<Number>((luma + in[2]) * scale, at + sizeof(Number));
    storeRounded<Number>((luma - in[1] - in[2]) * scale, at + 2 * sizeof(Number));
    storeRounded<Number>((withoutMark << 1 | (withoutMark & 1)) * scale, at + 3 * sizeof(Number));
}

using FilterOne = void (*)(char* at);

FilterOne functionOf(MeshoptView::Filter filter, std::size_t stride)
{
    switch (filter) {
    case MeshoptView::Filter::Octahedral:
        return stride == 4 ? filterOctahedral<std::int8_t> : filterOctahedral<std::int16_t>;
    case MeshoptView::Filter::Quaternion:
        return filterQuaternion;
    case MeshoptView::Filter::Exponential:
        return filterExponential;
    case MeshoptView::Filter::Color:
        return stride == 4 ? filterColor<std::uint8_t> : filterColor<std::uint16_t>;
    case MeshoptView::Filter::None:
        break;
    }
    return nullptr;
}
} // namespace

void applyMeshoptFilter(const MeshoptView& view, std::string& elements)
{
    const FilterOne filter = functionOf(view.filter, view.stride);
    const std::size_t size = view.filter == MeshoptView::Filter::Exponential ? 4 : view.stride;
    for (std::size_t at = 0; filter && at < elements.size(); at += size)
        filter(elements.data() + at);
}
} // namespace core::io
