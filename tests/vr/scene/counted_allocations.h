#pragma once

#include <atomic>

/// Number of calls of `new` in this program, by any thread. counted_allocations.cpp replaces the library's functions.
extern std::atomic<long> allocations;
