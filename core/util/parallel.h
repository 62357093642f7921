#pragma once

#include "core/util/worker_pool.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace core
{
inline std::size_t chunksOf(std::size_t count, std::size_t chunkSize)
{
    return (count + chunkSize - 1) / chunkSize;
}

/// Smallest number of chunks that is shared among threads. Fewer run as one chunk on the calling thread,
/// because waking another core would cost more than it saves.
constexpr std::size_t minChunks = 4;

/// Calls work(chunk, begin, end) for each chunk of [0, count), on all cores and in any order. Chunk limits do not
/// depend on the number of threads: results stored by chunk and joined in order are the same on any machine. Rethrows
/// the first exception.
template <typename Work> void forEachChunk(std::size_t count, std::size_t chunkSize, Work work)
{
    const std::size_t chunks = chunksOf(count, chunkSize);
    if (chunks == 0)
        return;
    if (chunks < minChunks)
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

/// Calls work(begin, end, part) for each chunk of [0, count) on all cores; each call appends to its own `part`. Returns
/// the parts joined in the order of the chunks.
template <typename Part, typename Work> Part joinChunks(std::size_t count, std::size_t chunkSize, Work work)
{
    std::vector<Part> parts(std::max<std::size_t>(1, chunksOf(count, chunkSize)));
    forEachChunk(count, chunkSize,
                 [&](std::size_t chunk, std::size_t begin, std::size_t end) { work(begin, end, parts[chunk]); });
    for (std::size_t i = 1; i < parts.size(); ++i)
        parts[0].insert(parts[0].end(), parts[i].begin(), parts[i].end());
    return std::move(parts[0]);
}
} // namespace core
