// Finds equal points by hashing in three passes, each on all cores:
//   1. file    each chunk's points are sorted by hash into that chunk's buckets, in the order of the file
//   2. search  each bucket is collected from all chunks, small enough for a core's cache; each point gets the index of
//              the first point that equals it
//   3. number  first points are numbered in the order of the file: a bit marks each, and the count of bits before it is
//              its number; the bits are few enough for the cache

#include "core/io/mesh/vertex_welder.h"

#include "core/util/parallel.h"

#include <bit>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

namespace core::io
{
namespace
{
constexpr std::size_t chunkSize = 1 << 14;
constexpr std::size_t pointsPerBucket = 1 << 12, maxBuckets = 512;

struct Bits
{
    explicit Bits(const Vec3f& p) : x(of(p.x())), y(of(p.y())), z(of(p.z())) {}

    friend bool operator==(const Bits&, const Bits&) = default;

    std::uint32_t hash(std::uint64_t seed) const
    {
        constexpr std::uint64_t factor = 0x9e3779b97f4a7c15U; // 2^64 / golden ratio: Fibonacci hashing
        std::uint64_t h = seed;
        for (const std::uint32_t part : {x, y, z}) {
            h = (h ^ part) * factor;
            h ^= h >> 29;
        }
        return static_cast<std::uint32_t>(h >> 16);
    }

    std::uint32_t x, y, z;

private:
    static std::uint32_t of(float x)
    {
        return std::bit_cast<std::uint32_t>(x + 0.0F);
    } // adding 0 removes the sign of -0
};

class PointBuckets
{
public:
    PointBuckets(std::size_t count, const PointLoader& load, const std::stop_token& stop)
        : m_count(count)
        , m_buckets(std::bit_ceil(std::clamp<std::size_t>(count / pointsPerBucket, 1, maxBuckets)))
        , m_load(load)
        , m_stop(stop)
        , m_bucketOf(count)
        , m_filed(count)
        , m_numbers(count)
        , m_starts(chunksOf(count, chunkSize) * m_buckets + 1, static_cast<Slot>(count))
    {}

    WeldedPoints find()
    {
        inChunks([this](std::size_t chunk, std::size_t begin, std::size_t end) { file(chunk, begin, end); });
        forEachChunk(m_buckets, 1, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t bucket = begin; bucket < end; ++bucket)
                search(bucket);
        });
        return number();
    }

private:
    struct Filed
    {
        Bits bits;
        Slot index; ///< index of the point in the file
    };

    /// Calls work(chunk, begin, end) for single chunks, even if forEachChunk() combines several.
    template <typename Work> void inChunks(Work work) const
    {
        forEachChunk(m_count, chunkSize, [&](std::size_t chunk, std::size_t first, std::size_t last) {
            for (std::size_t begin = first; begin < last; begin += chunkSize, ++chunk) {
                if (m_stop.stop_requested())
                    throw ReadingCancelled();
                work(chunk, begin, std::min(last, begin + chunkSize));
            }
        });
    }

    /// Returns the index in m_filed of a chunk's first point in a bucket. The bucket ends where the next one begins.
    Slot& startOf(std::size_t chunk, std::size_t bucket) { return m_starts[chunk * m_buckets + bucket]; }

    std::span<const Filed> contentOf(std::size_t chunk, std::size_t bucket)
    {
        return m_filed.part(startOf(chunk, bucket), startOf(chunk, bucket + 1));
    }

    void file(std::size_t chunk, std::size_t begin, std::size_t end)
    {
        std::array<Vec3f, chunkSize> points;
        m_load(begin, std::span(points).first(end - begin));
        std::vector<Slot> places(m_buckets);
        for (std::size_t i = begin; i < end; ++i) {
            m_bucketOf[i] = static_cast<std::uint16_t>(Bits(points[i - begin]).hash(m_seed) & (m_buckets - 1));
            ++places[m_bucketOf[i]];
        }
        auto sum = static_cast<Slot>(begin);
        for (std::size_t bucket = 0; bucket < m_buckets; ++bucket) {
            startOf(chunk, bucket) = sum;
            sum += std::exchange(places[bucket], sum);
        }
        for (std::size_t i = begin; i < end; ++i)
            m_filed[places[m_bucketOf[i]]++] = {Bits(points[i - begin]), static_cast<Slot>(i)};
    }

    /// Finds for each point in a bucket the first equal point, with a hash table with open addressing.
    void search(std::size_t bucket)
    {
        if (m_stop.stop_requested())
            throw ReadingCancelled();
        const std::size_t chunks = chunksOf(m_count, chunkSize);
        std::vector<Filed> content;
        content.reserve(2 * m_count / m_buckets);
        for (std::size_t chunk = 0; chunk < chunks; ++chunk)
            content.insert(content.end(), contentOf(chunk, bucket).begin(), contentOf(chunk, bucket).end());
        std::vector<Slot> table(std::bit_ceil(2 * content.size() + 1), noSlot);
        const std::size_t mask = table.size() - 1;
        Slot next = 0;
        for (std::size_t chunk = 0; chunk < chunks; ++chunk)
            for (Slot place = startOf(chunk, bucket); place < startOf(chunk, bucket + 1); ++place) {
                const Slot i = next++;
                std::size_t at = (content[i].bits.hash(m_seed) >> std::countr_zero(m_buckets)) & mask;
                while (table[at] != noSlot && content[table[at]].bits != content[i].bits)
                    at = (at + 1) & mask;
                if (table[at] == noSlot)
                    table[at] = i;
                m_numbers[place] = content[table[at]].index;
            }
    }

    /// Numbers the distinct points. Before, m_numbers has for each filed point the index of its first equal point;
    /// afterwards it has for each point of the file the number of its distinct point.
    WeldedPoints number()
    {
        std::vector<FirstOnes> firstOnes(chunksOf(m_count, firstOnesSize));
        inChunks([&](std::size_t chunk, std::size_t begin, std::size_t end) {
            const std::vector<Slot> filed(&m_numbers[begin], &m_numbers[begin] + (end - begin));
            std::vector<Slot> places(&startOf(chunk, 0), &startOf(chunk, m_buckets));
            for (std::size_t i = begin; i < end; ++i) {
                m_numbers[i] = filed[places[m_bucketOf[i]]++ - begin];
                firstOnes[i / firstOnesSize].bits |= std::uint64_t(m_numbers[i] == i) << i % firstOnesSize;
            }
        });
        Slot distinct = 0;
        for (FirstOnes& ones : firstOnes) {
            ones.before = distinct;
            distinct += static_cast<Slot>(std::popcount(ones.bits));
        }
        WeldedPoints same{LargeBuffer<Slot>(0), std::vector<Slot>(distinct)};
        inChunks([&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Slot first = m_numbers[i];
                const FirstOnes& ones = firstOnes[first / firstOnesSize];
                m_numbers[i] =
                    ones.before +
                    static_cast<Slot>(std::popcount(ones.bits & ((std::uint64_t(1) << first % firstOnesSize) - 1)));
                if (first == i)
                    same.firsts[m_numbers[i]] = first;
            }
        });
        same.numbers = std::move(m_numbers);
        return same;
    }

    /// Information about 64 consecutive points: a bit for each that is the first of its kind, and the number of first
    /// points before them.
    static constexpr std::size_t firstOnesSize = 64;
    struct FirstOnes
    {
        std::uint64_t bits = 0;
        Slot before = 0;
    };
    static_assert(chunkSize % firstOnesSize == 0); // no two cores write to the same bits

    /// Random, so that no file can be made whose points have equal hashes.
    const std::uint64_t m_seed = std::random_device()();
    std::size_t m_count;
    std::size_t m_buckets; ///< a power of two
    const PointLoader& m_load;
    const std::stop_token& m_stop;
    LargeBuffer<std::uint16_t> m_bucketOf;
    LargeBuffer<Filed> m_filed;
    LargeBuffer<Slot> m_numbers;
    std::vector<Slot> m_starts;
};
} // namespace

WeldedPoints weldPoints(std::size_t count, const PointLoader& load, const std::stop_token& stop)
{
    return PointBuckets(count, load, stop).find();
}

namespace
{
/// Keeps the values of these points, whose indices ascend.
template <class Value> void keep(std::vector<Value>& values, std::span<const Slot> points)
{
    if (values.empty())
        return;
    for (std::size_t i = 0; i < points.size(); ++i) // a point moves only to a lower or equal index
        values[i] = values[points[i]];
    values.resize(points.size());
}

/// Returns the points that may be merged with each other: the indices of all points sorted by their parts, and where
/// each part begins.
std::pair<std::vector<Slot>, std::vector<Slot>> pointsByPart(const std::vector<PartId>& parts)
{
    std::vector<Slot> starts(std::size_t(std::numeric_limits<PartId>::max()) + 2, 0);
    for (const PartId part : parts)
        ++starts[part + std::size_t(1)];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<Slot> points(parts.size()), next = starts;
    for (Slot v = 0; v < parts.size(); ++v)
        points[next[parts[v]]++] = v;
    return {std::move(points), std::move(starts)};
}

WeldedPoints weldWithinParts(const TriangleMesh& mesh, const std::stop_token& stop)
{
    const auto [points, starts] = pointsByPart(mesh.parts);
    WeldedPoints same{LargeBuffer<Slot>(mesh.points.size()), {}};
    for (std::size_t part = 0; part + 1 < starts.size(); ++part) {
        const auto own = std::span(points).subspan(starts[part], starts[part + 1] - starts[part]);
        if (own.empty())
            continue;
        const WeldedPoints of = weldPoints(
            own.size(),
            [&](std::size_t begin, std::span<Vec3f> into) {
                for (std::size_t i = 0; i < into.size(); ++i)
                    into[i] = mesh.points[own[begin + i]];
            },
            stop);
        for (std::size_t i = 0; i < own.size(); ++i)
            same.numbers[own[i]] = own[of.firsts[of.numbers[i]]];
    }
    for (Slot v = 0; v < mesh.points.size(); ++v) { // the first of equal points comes before the others
        const Slot first = same.numbers[v];
        if (first == v)
            same.firsts.push_back(v);
        same.numbers[v] = first == v ? static_cast<Slot>(same.firsts.size() - 1) : same.numbers[first];
    }
    return same;
}
} // namespace

void weld(TriangleMesh& mesh, const std::stop_token& stop)
{
    const auto load = [&](std::size_t begin, std::span<Vec3f> into) {
        std::copy_n(mesh.points.begin() + static_cast<std::ptrdiff_t>(begin), into.size(), into.begin());
    };
    const WeldedPoints same =
        mesh.parts.empty() ? weldPoints(mesh.points.size(), load, stop) : weldWithinParts(mesh, stop);
    if (same.firsts.size() == mesh.points.size())
        return;
    keep(mesh.points, same.firsts);
    keep(mesh.colors, same.firsts);
    keep(mesh.masks, same.firsts);
    keep(mesh.parts, same.firsts);
    for (Triangle& triangle : mesh.triangles)
        for (Slot& corner : triangle)
            corner = same.numbers[corner];
}
} // namespace core::io
