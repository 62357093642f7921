#pragma once

#include "core/geometry/geometry.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace core::io
{
inline constexpr std::size_t maxPaletteColors = 64;

/// Returns the colour as text, for example "c86e50".
std::string hexOf(const Rgb& color);
/// Returns the colour of a text of exactly six hexadecimal digits; nothing for any other text.
std::optional<Rgb> colorOf(std::string_view word);

/// Returns the palette as text, for example "fettle palette c86e50 8a5a3c", to be written as a comment near the start
/// of a file.
std::string paletteWords(std::span<const Rgb> palette);
/// Returns the palette in such a comment near the start of a file. Empty if there is none or it does not have the form
/// of paletteWords().
std::vector<Rgb> paletteIn(std::string_view start);
} // namespace core::io
