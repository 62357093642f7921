#pragma once

#include "worker_pool.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace core
{
inline std::size_t chunksOf(std::size_t count, std::size_t chunkSize)
{
    return (count + chunkSize - 1) / chunkSize;
}

/// Fewer chunks than this are not worth waking another core for: they are done as one.
constexpr std::size_t leastChunks = 4;

/// Calls work(chunk, begin, end) for each chunk of [0, count), on all cores and in any order. Chunks are fixed by index: who
/// keeps a result for each chunk and joins them in order gets the same on any machine. The first exception is passed on.
template <typename Work> void forEachChunk(std::size_t count, std::size_t chunkSize, Work work)
{
    const std::size_t chunks = chunksOf(count, chunkSize);
    if (chunks == 0)
        return;
    if (chunks < leastChunks)
        return work(std::size_t(0), std::size_t(0), count);
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failureMutex;
    const auto run = [&] {
        try {
            for (std::size_t chunk = next++; chunk < chunks; chunk = next++)
                work(chunk, chunk * chunkSize, std::min(count, (chunk + 1) * chunkSize));
        } catch (...) {
            const std::lock_guard lock(failureMutex);
            failure = failure ? failure : std::current_exception();
            next = chunks;
        }
    };
    WorkerPool::shared().run(std::cref(run), chunks - 1);
    if (failure)
        std::rethrow_exception(failure);
}
} // namespace core
