#pragma once

#include "format.h"

#include "../triangle_mesh.h"

#include <bit>

namespace core::mesh_io
{
/// Numbers the distinct points (-0 = 0) in order of appearance. Open addressing over the points themselves.
class Welder
{
public:
    /// It will be given about so many distinct points.
    explicit Welder(std::size_t points = 0) : m_table(std::bit_ceil(std::max<std::size_t>(1024, 2 * (points + 1))), noSlot)
    {
        m_points.reserve(points);
    }

    Slot add(const Vec3f& p)
    {
        if (2 * (m_points.size() + 1) > m_table.size())
            grow();
        Slot& entry = m_table[find(p)];
        if (entry == noSlot) {
            entry = static_cast<Slot>(m_points.size());
            m_points.push_back(p);
        }
        return entry;
    }

    std::size_t size() const { return m_points.size(); }
    std::vector<Vec3f> takePoints() { return std::move(m_points); }

private:
    static std::uint64_t hash(const Vec3f& p)
    {
        std::uint64_t h = 0;
        for (int i = 0; i < 3; ++i) {
            h = (h ^ std::bit_cast<std::uint32_t>(p[i] + 0.0f)) *
                0x9e3779b97f4a7c15u; // 2^64 / golden ratio: Fibonacci hashing
            h ^= h >> 29;
        }
        return h;
    }

    std::size_t find(const Vec3f& p) const
    {
        const std::size_t mask = m_table.size() - 1;
        std::size_t at = hash(p) & mask;
        while (m_table[at] != noSlot && m_points[m_table[at]] != p)
            at = (at + 1) & mask;
        return at;
    }

    void grow()
    {
        m_table.assign(2 * m_table.size(), noSlot);
        for (std::size_t i = 0; i < m_points.size(); ++i)
            m_table[find(m_points[i])] = static_cast<Slot>(i);
    }

    std::vector<Vec3f> m_points;
    std::vector<Slot> m_table; ///< size: a power of two
};

/// Makes vertices of equal bits one, where there are any; the first one's colour stays. Vertices keep their order.
void weld(TriangleMesh& mesh, StopCheck stopCheck);
} // namespace core::mesh_io
