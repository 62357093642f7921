#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace core::io
{
/// A decimal number, a plus before it or not, and nothing else; in any locale. Rounded to the nearest. Empty: none, or
/// not finite.
std::optional<float> parseFloat(std::string_view word);
std::optional<double> parseDouble(std::string_view word);
std::optional<std::int64_t> parseInteger(std::string_view word);
} // namespace core::io
