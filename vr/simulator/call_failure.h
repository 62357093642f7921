#pragma once

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace simulator
{
/// Thrown to end the call that is being answered.
struct Failure
{
    XrResult result;
    const char* reason; ///< for the log
};

inline void require(bool condition, XrResult otherwise, const char* reason)
{
    if (!condition)
        throw Failure{otherwise, reason};
}

template <class T> T& given(T* pointer)
{
    require(pointer, XR_ERROR_VALIDATION_FAILURE, "a pointer is null");
    return *pointer;
}

/// Of a structure that says its own type.
template <class T> T& given(T* pointer, XrStructureType type)
{
    require(given(pointer).type == type, XR_ERROR_VALIDATION_FAILURE, "a structure's type is not set, or another's");
    return *pointer;
}

/// What the client offers for the answer of a call in the two-call idiom.
template <class T> struct Room
{
    std::uint32_t capacity;
    std::uint32_t* count;
    T* items;
};

/// `put(T& to, item)` for each item, if there is room.
template <class T, class Items, class Put> void answer(Room<T> room, const Items& items, Put put)
{
    given(room.count) = static_cast<std::uint32_t>(std::size(items));
    if (room.capacity == 0)
        return;
    given(room.items);
    require(room.capacity >= *room.count, XR_ERROR_SIZE_INSUFFICIENT, "the array is too small");
    T* to = room.items;
    for (const auto& item : items)
        put(*to++, item);
}

template <class T, class Items> void answer(Room<T> room, const Items& items)
{
    answer(room, items, [](T& to, const T& item) { to = item; });
}

/// With its terminating zero.
inline void answerText(Room<char> room, std::string_view text)
{
    given(room.count) = static_cast<std::uint32_t>(text.size() + 1);
    if (room.capacity == 0)
        return;
    given(room.items);
    require(room.capacity >= *room.count, XR_ERROR_SIZE_INSUFFICIENT, "the buffer is too small");
    std::memcpy(room.items, text.data(), text.size());
    room.items[text.size()] = 0;
}

template <std::size_t N> void copyText(char (&to)[N], std::string_view text)
{
    const std::size_t length = text.copy(to, N - 1);
    to[length] = 0;
}
} // namespace simulator
