#include "core/io/mesh/stl_colors.h"

#include "core/io/mesh/mean_color.h"

#include <algorithm>

namespace core::io
{
namespace
{
constexpr std::uint16_t flag = 1 << 15;

std::uint8_t channel(std::uint16_t word, int shift)
{
    constexpr int max = 31;
    return static_cast<std::uint8_t>(((word >> shift & max) * 255 + max / 2) / max);
}

/// Returns the colour of the whole model in a header written by Magics.
std::optional<Rgb> colorOfHeader(std::string_view header)
{
    constexpr std::string_view title = "COLOR=";
    const std::size_t at = header.find(title);
    if (at == std::string_view::npos || header.size() < at + title.size() + 3)
        return std::nullopt;
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(header[at + title.size() + i]); };
    return Rgb{byte(0), byte(1), byte(2)};
}

Rgb viscamColor(std::uint16_t word)
{
    return (word & flag) != 0 ? Rgb{channel(word, 10), channel(word, 5), channel(word, 0)} : Rgb();
}
} // namespace

std::vector<Rgb> stlColors(std::string_view header, std::span<const std::uint16_t> words, const TriangleMesh& mesh,
                           StopCheck& stopCheck)
{
    const std::optional<Rgb> whole = colorOfHeader(header);
    if (!whole && std::ranges::none_of(words, [](std::uint16_t word) { return (word & flag) != 0; }))
        return {};
    // If no triangle has a colour word, 0 does not mean black: every triangle has the header's colour.
    const bool isPlain = std::ranges::all_of(words, [](std::uint16_t word) { return word == 0; });
    const auto colorOf = [&](std::uint16_t word) {
        if (!whole)
            return viscamColor(word);
        return isPlain || (word & flag) != 0 ? *whole : Rgb{channel(word, 0), channel(word, 5), channel(word, 10)};
    };
    std::vector<MeanColor> means(mesh.points.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
        stopCheck();
        for (const Slot corner : mesh.triangles[i])
            means[corner].add(colorOf(words[i]));
    }
    std::vector<Rgb> colors;
    colors.reserve(means.size());
    std::ranges::transform(means, std::back_inserter(colors), &MeanColor::color);
    return colors;
}
} // namespace core::io
