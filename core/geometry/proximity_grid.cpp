#include "core/geometry/proximity_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace core
{
namespace
{
/// pointsPerCell: target for the mean number of points per cell. If the mean is at least four times higher, cells are
/// made smaller; the count is assumed to fall with the square of the side, as for points on a surface.
/// maxCellsPerSide: largest factor by which the side of a cell is reduced.
constexpr double pointsPerCell = 16;
constexpr double maxCellsPerSide = 8;
} // namespace

ProximityGrid::ProximityGrid(const std::vector<Vec3>& points, double reach) : m_reach(reach)
{
    build(points, 2 * reach);
    if (points.empty())
        return;
    const double mean = static_cast<double>(points.size()) / static_cast<double>(cells());
    const double perSide = std::floor(std::sqrt(mean / pointsPerCell));
    if (perSide >= 2)
        build(points, 2 * reach / std::min(perSide, maxCellsPerSide));
}

void ProximityGrid::build(const std::vector<Vec3>& points, double cellSize)
{
    m_perCell = 1 / cellSize;
    m_buckets.assign(std::bit_ceil(2 * points.size() + 1), noSlot);
    m_cells.clear();
    std::vector<Slot> own(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Place place = placeOf(points[i]);
        Slot cell = cellAt(place);
        if (cell == noSlot) {
            Slot& bucket = m_buckets[bucketOf(place)];
            cell = static_cast<Slot>(m_cells.size());
            m_cells.push_back({place, bucket});
            bucket = cell;
        }
        own[i] = cell;
        ++m_cells[cell].count;
    }
    Slot first = 0;
    for (Cell& cell : m_cells) {
        cell.first = first;
        first += std::exchange(cell.count, 0);
    }
    m_points.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        Cell& cell = m_cells[own[i]];
        m_points[cell.first + cell.count++] = static_cast<Slot>(i);
    }
}

std::size_t ProximityGrid::bucketOf(const Place& place) const
{
    // Spatial hash with the three large primes of Teschner et al. 2003.
    const auto part = [](std::int64_t x, std::uint64_t prime) { return static_cast<std::uint64_t>(x) * prime; };
    const std::uint64_t hash = part(place.x(), 73856093) ^ part(place.y(), 19349663) ^ part(place.z(), 83492791);
    return (hash ^ hash >> 17) & (m_buckets.size() - 1);
}
} // namespace core
