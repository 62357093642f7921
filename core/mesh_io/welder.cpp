// Points that are one, by hashing, in four passes over chunks of points, each on all cores:
//   1. count   the points of each chunk in each of many drawers, by hash
//   2. file    the points into the drawers, those of a drawer in the order of the file
//   3. search  each drawer, which a core's cache holds: each point takes the index of the first that is like it
//   4. number  the first ones in the order of the file

#include "welder.h"

#include "../parallel.h"

#include <bit>
#include <random>

namespace core::mesh_io
{
namespace
{
constexpr std::size_t chunkSize = 1 << 14;
constexpr std::size_t pointsPerDrawer = 1 << 12, mostDrawers = 512;

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
    static std::uint32_t of(float x) { return std::bit_cast<std::uint32_t>(x + 0.0F); } // adding 0 takes the sign from -0
};

class PointDrawers
{
public:
    PointDrawers(std::size_t count, const PointLoader& load, const std::stop_token& stop)
        : m_count(count)
        , m_drawers(std::bit_ceil(std::clamp<std::size_t>(count / pointsPerDrawer, 1, mostDrawers)))
        , m_load(load)
        , m_stop(stop)
        , m_drawerOf(count)
        , m_filed(count)
        , m_starts(chunksOf(count, chunkSize) * m_drawers + 1)
    {}

    SamePoints find()
    {
        countPoints();
        filePoints();
        forEachChunk(m_drawers, 1, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t drawer = begin; drawer < end; ++drawer)
                search(drawer);
        });
        return number();
    }

private:
    struct Filed
    {
        Bits bits;
        Slot index; ///< of the point; once searched, of the first that is like it
    };

    /// work(chunk, begin, end), whatever forEachChunk puts together.
    template <typename Work> void inChunks(Work work) const
    {
        forEachChunk(m_count, chunkSize, [&](std::size_t chunk, std::size_t first, std::size_t last) {
            for (std::size_t begin = first; begin < last; begin += chunkSize, ++chunk) {
                if (m_stop.stop_requested())
                    throw ReadingStopped();
                work(chunk, begin, std::min(last, begin + chunkSize));
            }
        });
    }

    /// work(i, bits) for each point of a chunk.
    template <typename Work> void inPoints(std::size_t begin, std::size_t end, Work work) const
    {
        std::array<Vec3f, chunkSize> points;
        m_load(begin, std::span(points).first(end - begin));
        for (std::size_t i = begin; i < end; ++i)
            work(i, Bits(points[i - begin]));
    }

    /// Where what a chunk has for a drawer begins. By drawers first: a drawer's content is in the order of the chunks.
    Slot& startOf(std::size_t chunk, std::size_t drawer) { return m_starts[drawer * chunksOf(m_count, chunkSize) + chunk]; }

    void countPoints()
    {
        inChunks([&](std::size_t chunk, std::size_t begin, std::size_t end) {
            std::vector<Slot> counts(m_drawers);
            inPoints(begin, end, [&](std::size_t i, const Bits& bits) {
                m_drawerOf[i] = static_cast<std::uint16_t>(bits.hash(m_seed) & (m_drawers - 1));
                ++counts[m_drawerOf[i]];
            });
            for (std::size_t drawer = 0; drawer < m_drawers; ++drawer)
                startOf(chunk, drawer) = counts[drawer];
        });
        Slot sum = 0;
        for (Slot& start : m_starts)
            sum += std::exchange(start, sum);
    }

    std::vector<Slot> startsOf(std::size_t chunk)
    {
        std::vector<Slot> starts(m_drawers);
        for (std::size_t drawer = 0; drawer < m_drawers; ++drawer)
            starts[drawer] = startOf(chunk, drawer);
        return starts;
    }

    void filePoints()
    {
        inChunks([&](std::size_t chunk, std::size_t begin, std::size_t end) {
            std::vector<Slot> places = startsOf(chunk);
            inPoints(begin, end, [&](std::size_t i, const Bits& bits) { m_filed[places[m_drawerOf[i]]++] = {bits, static_cast<Slot>(i)}; });
        });
    }

    /// Open addressing.
    void search(std::size_t drawer)
    {
        if (m_stop.stop_requested())
            throw ReadingStopped();
        const std::size_t chunks = chunksOf(m_count, chunkSize);
        const std::span<Filed> content = m_filed.part(m_starts[drawer * chunks], m_starts[(drawer + 1) * chunks]);
        std::vector<Slot> table(std::bit_ceil(2 * content.size() + 1), noSlot);
        const std::size_t mask = table.size() - 1;
        for (Slot i = 0; i < content.size(); ++i) {
            std::size_t at = (content[i].bits.hash(m_seed) >> std::countr_zero(m_drawers)) & mask;
            while (table[at] != noSlot && content[table[at]].bits != content[i].bits)
                at = (at + 1) & mask;
            if (table[at] == noSlot)
                table[at] = i;
            content[i].index = content[table[at]].index;
        }
    }

    SamePoints number()
    {
        SamePoints same{LargeBuffer<Slot>(m_count), {}};
        LargeBuffer<bool> isFirst(m_count);
        std::vector<std::size_t> distinct(chunksOf(m_count, chunkSize) + 1);
        inChunks([&](std::size_t chunk, std::size_t begin, std::size_t end) {
            std::vector<Slot> places = startsOf(chunk);
            for (std::size_t i = begin; i < end; ++i) {
                same.numbers[i] = m_filed[places[m_drawerOf[i]]++].index;
                isFirst[i] = same.numbers[i] == i;
                distinct[chunk + 1] += isFirst[i] ? 1 : 0;
            }
        });
        for (std::size_t chunk = 1; chunk < distinct.size(); ++chunk)
            distinct[chunk] += distinct[chunk - 1];
        same.firsts.resize(distinct.back());
        inChunks([&](std::size_t chunk, std::size_t begin, std::size_t end) {
            std::size_t next = distinct[chunk];
            for (std::size_t i = begin; i < end; ++i) {
                if (!isFirst[i])
                    continue;
                same.firsts[next] = static_cast<Slot>(i);
                same.numbers[i] = static_cast<Slot>(next++);
            }
        });
        inChunks([&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                if (!isFirst[i])
                    same.numbers[i] = same.numbers[same.numbers[i]];
        });
        return same;
    }

    const std::uint64_t m_seed = std::random_device()(); ///< nobody can make a file of points that hash alike
    std::size_t m_count;
    std::size_t m_drawers; ///< a power of two
    const PointLoader& m_load;
    const std::stop_token& m_stop;
    LargeBuffer<std::uint16_t> m_drawerOf;
    LargeBuffer<Filed> m_filed;
    std::vector<Slot> m_starts;
};
} // namespace

SamePoints samePoints(std::size_t count, const PointLoader& load, const std::stop_token& stop)
{
    return PointDrawers(count, load, stop).find();
}

void weld(TriangleMesh& mesh, const std::stop_token& stop)
{
    const auto load = [&](std::size_t begin, std::span<Vec3f> into) { std::copy_n(mesh.points.begin() + static_cast<std::ptrdiff_t>(begin), into.size(), into.begin()); };
    const SamePoints same = samePoints(mesh.points.size(), load, stop);
    if (same.firsts.size() == mesh.points.size())
        return;
    for (std::size_t i = 0; i < same.firsts.size(); ++i) { // no point moves up
        mesh.points[i] = mesh.points[same.firsts[i]];
        if (!mesh.colors.empty())
            mesh.colors[i] = mesh.colors[same.firsts[i]];
    }
    mesh.points.resize(same.firsts.size());
    if (!mesh.colors.empty())
        mesh.colors.resize(same.firsts.size());
    for (Triangle& triangle : mesh.triangles)
        for (Slot& corner : triangle)
            corner = same.numbers[corner];
}
} // namespace core::mesh_io
