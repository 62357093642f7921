#include "core/io/mesh/number_parsing.h"

#include <charconv>
#include <cmath>

namespace core::io
{
namespace
{
const char* afterPlus(std::string_view word)
{
    return word.data() + (word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
}

/// Parses a number outside float32's range. Returns zero or a denormal for a tiny number, NaN for one that is too
/// large.
float farNumber(std::string_view word)
{
    double value = 0;
    const auto [end, error] = std::from_chars(afterPlus(word), word.data() + word.size(), value);
    const bool tiny = error == std::errc() ? std::abs(value) < 1 : word.find('-', 1) != std::string_view::npos;
    if (!tiny)
        return std::nanf("");
    return error == std::errc() ? static_cast<float>(value) : word.front() == '-' ? -0.0f : 0.0f;
}

template <class Number> std::optional<Number> parsed(std::string_view word)
{
    Number value = 0;
    const char* const last = word.data() + word.size();
    const auto [end, error] = std::from_chars(afterPlus(word), last, value);
    if (error != std::errc() || end != last)
        return std::nullopt;
    return value;
}
} // namespace

std::optional<float> parseFloat(std::string_view word)
{
    const char* const last = word.data() + word.size();
    float value = 0;
    const auto [end, error] = std::from_chars(afterPlus(word), last, value);
    if (error == std::errc::result_out_of_range && end == last)
        value = farNumber(word);
    else if (error != std::errc() || end != last)
        return std::nullopt;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<double> parseDouble(std::string_view word)
{
    const auto value = parsed<double>(word);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> parseInteger(std::string_view word)
{
    return parsed<std::int64_t>(word);
}
} // namespace core::io
