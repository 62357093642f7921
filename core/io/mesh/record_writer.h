#pragma once

#include "core/io/large_buffer.h"
#include "core/util/atomic_file.h"
#include "core/util/parallel.h"

namespace core::io
{
/// Writes `count` records of `size` bytes. store(i, into) must write the bytes of record i to `into`; it is called on
/// all cores.
template <typename Store> void writeRecords(AtomicFile& out, std::size_t count, std::size_t size, Store store)
{
    constexpr std::size_t bytesAtOnce = std::size_t(1) << 23, recordsPerChunk = std::size_t(1) << 13;
    const std::size_t max = std::min(count, bytesAtOnce / size);
    LargeBuffer<char> buffer(max * size);
    for (std::size_t first = 0; first < count; first += max) {
        const std::size_t now = std::min(max, count - first);
        forEachChunk(now, recordsPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                store(first + i, &buffer[i * size]);
        });
        out.write({buffer.data(), now * size});
    }
}
} // namespace core::io
