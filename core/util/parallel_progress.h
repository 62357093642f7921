#pragma once

#include "core/util/job_control.h"
#include "core/util/parallel.h"

namespace core
{
/// Runs forEachChunk() on one part of [0, count) after the other. Reports progress between the parts, on the calling
/// thread. Skips the remaining work when cancelled.
template <typename Work>
void forEachChunkWithProgress(std::size_t count, std::size_t chunkSize, const JobControl& control, Work work)
{
    constexpr std::size_t chunksPerPart = 16, maxParts = 256;
    const std::size_t perPart = std::max(chunksPerPart, chunksOf(chunksOf(count, chunkSize), maxParts));
    for (std::size_t first = 0; first < count && !control.isCancelled(); first += perPart * chunkSize) {
        const std::size_t here = std::min(count - first, perPart * chunkSize);
        forEachChunk(here, chunkSize, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            if (!control.isCancelled())
                work(first / chunkSize + chunk, first + begin, first + end);
        });
        control.reportProgress(static_cast<double>(first + here) / static_cast<double>(count));
    }
}
} // namespace core
