#pragma once

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace simulator
{
/// Thrown to end the present call with an error.
struct CallFailure
{
    XrResult result;
    const char* reason; ///< text for the log
};

inline void require(bool condition, XrResult otherwise, const char* reason)
{
    if (!condition)
        throw CallFailure{otherwise, reason};
}

template <class T> T& validated(T* pointer)
{
    require(pointer, XR_ERROR_VALIDATION_FAILURE, "a pointer is null");
    return *pointer;
}

/// Returns the structure. Fails unless its type is set as expected.
template <class T> T& validated(T* pointer, XrStructureType type)
{
    require(validated(pointer).type == type, XR_ERROR_VALIDATION_FAILURE,
            "a structure's type is not set, or another's");
    return *pointer;
}

/// The client's array for the result of a function with the two-call idiom.
template <class T> struct OutputArray
{
    std::uint32_t capacity;
    std::uint32_t* count;
    T* items;
};

/// Writes the number of items and, unless the capacity is 0, calls put(to, item) for each item. Fails if the items do
/// not fit.
template <class T, class Items, class Put> void writeItems(OutputArray<T> output, const Items& items, Put put)
{
    validated(output.count) = static_cast<std::uint32_t>(std::size(items));
    if (output.capacity == 0)
        return;
    validated(output.items);
    require(output.capacity >= *output.count, XR_ERROR_SIZE_INSUFFICIENT, "the array is too small");
    T* to = output.items;
    for (const auto& item : items)
        put(*to++, item);
}

template <class T, class Items> void writeItems(OutputArray<T> output, const Items& items)
{
    writeItems(output, items, [](T& to, const T& item) { to = item; });
}

/// Writes the text with its terminating zero, in the two-call idiom.
inline void writeText(OutputArray<char> output, std::string_view text)
{
    validated(output.count) = static_cast<std::uint32_t>(text.size() + 1);
    if (output.capacity == 0)
        return;
    validated(output.items);
    require(output.capacity >= *output.count, XR_ERROR_SIZE_INSUFFICIENT, "the buffer is too small");
    std::memcpy(output.items, text.data(), text.size());
    output.items[text.size()] = 0;
}

template <std::size_t N> void copyText(char (&to)[N], std::string_view text)
{
    const std::size_t length = text.copy(to, N - 1);
    to[length] = 0;
}
} // namespace simulator
