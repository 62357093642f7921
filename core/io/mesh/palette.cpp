#include "core/io/mesh/palette.h"

#include <charconv>

namespace core::io
{
namespace
{
constexpr std::string_view title = "fettle palette";
constexpr std::size_t digits = 6;
} // namespace

std::string hexOf(const Rgb& color)
{
    constexpr std::string_view hex = "0123456789abcdef";
    std::string word;
    for (const std::uint8_t part : {color.r, color.g, color.b}) {
        word += hex[part >> 4];
        word += hex[part & 15];
    }
    return word;
}

std::optional<Rgb> colorOf(std::string_view word)
{
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, 16);
    if (word.size() != digits || error != std::errc() || end != word.data() + word.size())
        return std::nullopt;
    return Rgb{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
               static_cast<std::uint8_t>(value)};
}

std::string paletteWords(std::span<const Rgb> palette)
{
    std::string words(title);
    for (const Rgb& color : palette)
        words += ' ' + hexOf(color);
    return words;
}

std::vector<Rgb> paletteIn(std::string_view start)
{
    std::size_t begin = std::string_view::npos;
    for (const std::string_view mark : {"\ncomment ", "# "})
        if (const std::size_t at = start.find(std::string(mark) + std::string(title)); at != std::string_view::npos)
            begin = at + mark.size() + title.size();
    if (begin == std::string_view::npos)
        return {};
    std::string_view rest = start.substr(begin, start.find_first_of("\r\n\"", begin) - begin);
    std::vector<Rgb> palette;
    while (rest.size() > digits && rest.front() == ' ' && palette.size() < maxPaletteColors) {
        const auto color = colorOf(rest.substr(1, digits));
        if (!color)
            return {};
        palette.push_back(*color);
        rest.remove_prefix(1 + digits);
    }
    return rest.empty() ? palette : std::vector<Rgb>();
}
} // namespace core::io
