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

/// "c86e50".
std::string hexOf(const Rgb& color);
/// Of nothing but six hexadecimal digits.
std::optional<Rgb> colorOf(std::string_view word);

/// "fettle palette c86e50 8a5a3c", for a comment of its own among a file's first lines.
std::string paletteWords(std::span<const Rgb> palette);
/// Of such a comment in the start of a file; empty if there is none, or it is not as we write it.
std::vector<Rgb> paletteIn(std::string_view start);
} // namespace core::io
