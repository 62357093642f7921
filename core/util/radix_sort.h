#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace core
{
/// Sorts by the projection `code`, a 64-bit number, ascending and stable. Cost: linear time, and a temporary copy of
/// the values; pays off for many values.
template <typename Value, typename Code = std::identity> void radixSort(std::vector<Value>& values, Code code = {})
{
    constexpr int digits = 8, bitsPerDigit = 8;
    constexpr std::size_t radix = std::size_t(1) << bitsPerDigit;
    const auto digitOf = [code](const Value& value, int digit) {
        const std::uint64_t number = std::invoke(code, value);
        return (number >> (bitsPerDigit * digit)) % radix;
    };
    std::vector<std::array<std::size_t, radix>> counts(digits);
    for (const Value& value : values)
        for (int digit = 0; digit < digits; ++digit)
            ++counts[static_cast<std::size_t>(digit)][digitOf(value, digit)];
    std::vector<Value> sorted(values.size());
    for (int digit = 0; digit < digits; ++digit) {
        std::array<std::size_t, radix>& places = counts[static_cast<std::size_t>(digit)];
        if (values.empty() || places[digitOf(values[0], digit)] == values.size())
            continue; // all values have the same digit
        for (std::size_t sum = 0; std::size_t & place : places)
            sum += std::exchange(place, sum);
        for (const Value& value : values)
            sorted[places[digitOf(value, digit)]++] = value;
        values.swap(sorted);
    }
}
} // namespace core
