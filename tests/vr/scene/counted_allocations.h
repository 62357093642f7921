#pragma once

#include <atomic>
#include <cstdlib>
#include <new>

/// How often `new` was asked in this program, by any thread. Takes the place of the library's: for one file of a
/// program.
inline std::atomic<long> allocations = 0;

void* operator new(std::size_t bytes)
{
    ++allocations;
    if (void* memory = std::malloc(bytes))
        return memory;
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
