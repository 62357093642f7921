#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace core::io
{
/// Parses a decimal number, with or without a leading plus, in the C locale. The word must contain nothing else. Rounds
/// to the nearest value. Returns nothing if it is not a number or not finite.
std::optional<float> parseFloat(std::string_view word);
std::optional<double> parseDouble(std::string_view word);
std::optional<std::int64_t> parseInteger(std::string_view word);
} // namespace core::io
