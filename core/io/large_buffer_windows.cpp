// Source: Microsoft Learn, "Large-Page Support", VirtualAlloc().
#include "core/io/large_buffer.h"

#include <cstdlib>
#include <new>
#include <windows.h>

namespace core
{
namespace
{
constexpr std::size_t worthPages = std::size_t(1) << 22; ///< 4 MiB

void release(void* memory)
{
    VirtualFree(memory, 0, MEM_RELEASE);
}

/// Returns memory in large pages. Null where the user may not lock pages in memory, as is usual: Windows has large
/// pages only in memory that it never swaps out.
void* inLargePages(std::size_t bytes)
{
    const std::size_t pageSize = GetLargePageMinimum();
    if (pageSize == 0)
        return nullptr;
    const std::size_t rounded = (bytes + pageSize - 1) / pageSize * pageSize;
    return VirtualAlloc(nullptr, rounded, MEM_RESERVE | MEM_COMMIT | MEM_LARGE_PAGES, PAGE_READWRITE);
}
} // namespace

std::unique_ptr<std::byte, void (*)(void*)> allocateLarge(std::size_t bytes)
{
    const bool isLarge = bytes >= worthPages;
    void* memory = isLarge ? inLargePages(bytes) : std::malloc(bytes + 1);
    if (isLarge && !memory)
        memory = VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
    if (!memory)
        throw std::bad_alloc();
    return {static_cast<std::byte*>(memory), isLarge ? release : std::free};
}

/// Does nothing: Windows gives large pages only when memory is allocated.
void adviseLargePages(void*, std::size_t) {}
} // namespace core
