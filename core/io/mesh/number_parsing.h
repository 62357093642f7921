#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace core::mesh_io
{
/// A decimal number, a plus before it or not, and nothing else; in any locale. Rounded to the nearest. Empty: none, or not finite.
std::optional<float> floatOf(std::string_view word);
std::optional<double> doubleOf(std::string_view word);
std::optional<std::int64_t> wholeOf(std::string_view word);
} // namespace core::mesh_io
