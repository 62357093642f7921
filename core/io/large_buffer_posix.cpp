#include "core/io/large_buffer.h"

#include <cstdlib>
#include <new>
#include <sys/mman.h>

namespace core
{
namespace
{
constexpr std::size_t pageSize = std::size_t(1) << 21; ///< large page size of common processors: 2 MiB
constexpr std::size_t worthPages = 2 * pageSize;
} // namespace

std::unique_ptr<std::byte, void (*)(void*)> allocateLarge(std::size_t bytes)
{
    const bool isLarge = bytes >= worthPages;
    const std::size_t rounded = isLarge ? (bytes + pageSize - 1) / pageSize * pageSize : bytes + 1;
    void* const memory = isLarge ? std::aligned_alloc(pageSize, rounded) : std::malloc(rounded);
    if (!memory)
        throw std::bad_alloc();
    adviseLargePages(memory, rounded);
    return {static_cast<std::byte*>(memory), std::free};
}

void adviseLargePages(void* memory, std::size_t bytes)
{
#ifdef MADV_HUGEPAGE
    void* first = memory;
    if (bytes >= worthPages && std::align(pageSize, pageSize, first, bytes))
        ::madvise(first, bytes, MADV_HUGEPAGE); // only a hint: the system may ignore it
#endif
}
} // namespace core
