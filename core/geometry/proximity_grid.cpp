#include "core/geometry/proximity_grid.h"

#include <bit>

namespace core
{
ProximityGrid::ProximityGrid(const std::vector<Vec3>& points, double reach) : m_perCell(1 / (2 * reach))
{
    m_buckets.assign(std::bit_ceil(2 * points.size() + 1), noSlot);
    m_entries.reserve(points.size());
    for (const Vec3& p : points) {
        const Cell cell = cellAt(m_perCell * p.array());
        Slot& bucket = m_buckets[bucketOf(cell)];
        m_entries.push_back({cell, bucket});
        bucket = static_cast<Slot>(m_entries.size() - 1);
    }
}

std::size_t ProximityGrid::bucketOf(const Cell& cell) const
{
    // Teschner et al. 2003: three large primes.
    const auto part = [](std::int64_t x, std::uint64_t prime) { return static_cast<std::uint64_t>(x) * prime; };
    const std::uint64_t hash = part(cell.x(), 73856093) ^ part(cell.y(), 19349663) ^ part(cell.z(), 83492791);
    return (hash ^ hash >> 17) & (m_buckets.size() - 1);
}
} // namespace core
