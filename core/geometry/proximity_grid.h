#pragma once

#include "core/geometry/geometry.h"

#include <span>
#include <vector>

namespace core
{
/// A hash grid of points with cells of one size, for queries by box. Cost: O(1) per point to build, O(nearby points)
/// per query.
class ProximityGrid
{
public:
    /// `reach` > 0: about half the side of the largest query box. A cell is two reaches wide, or narrower if the points
    /// are dense.
    ProximityGrid(const std::vector<Vec3>& points, double reach);

    /// Returns the number of cells that are not empty.
    std::size_t cells() const { return m_cells.size(); }
    /// Returns the points in a cell, ascending.
    std::span<const Slot> pointsIn(std::size_t cell) const
    {
        return std::span(m_points).subspan(m_cells[cell].first, m_cells[cell].count);
    }

    /// Calls visit(cell) for every non-empty cell that meets the box, in unspecified order.
    template <class Visit> void forEachCellIn(const Box& box, Visit visit) const
    {
        const Place first = placeOf(box.min()), last = placeOf(box.max());
        for (std::int64_t z = first.z(); z <= last.z(); ++z) {
            for (std::int64_t y = first.y(); y <= last.y(); ++y) {
                for (std::int64_t x = first.x(); x <= last.x(); ++x) {
                    if (const Slot cell = cellAt({x, y, z}); cell != noSlot)
                        visit(cell);
                }
            }
        }
    }
    /// Calls visit(i) for every point within reach of p, and for some farther points, in unspecified order.
    template <class Visit> void forEachNear(const Vec3& p, Visit visit) const
    {
        const Vec3 reach = Vec3::Constant(m_reach);
        forEachCellIn(Box(p - reach, p + reach), [&](Slot cell) {
            for (Slot i : pointsIn(cell))
                visit(i);
        });
    }

private:
    using Place = Eigen::Matrix<std::int64_t, 3, 1>;
    struct Cell
    {
        Place place;
        Slot next = noSlot; ///< next cell in the same hash bucket
        Slot first = 0, count = 0;
    };

    Place placeOf(const Vec3& p) const { return (m_perCell * p.array()).floor().cast<std::int64_t>().matrix(); }
    std::size_t bucketOf(const Place& place) const;
    Slot cellAt(const Place& place) const
    {
        Slot cell = m_buckets[bucketOf(place)];
        while (cell != noSlot && m_cells[cell].place != place)
            cell = m_cells[cell].next;
        return cell;
    }
    void build(const std::vector<Vec3>& points, double cellSize);

    double m_reach;
    double m_perCell = 0;
    std::vector<Slot> m_buckets; ///< first cell of each hash bucket; their number is a power of two
    std::vector<Cell> m_cells;
    std::vector<Slot> m_points; ///< points grouped by cell
};
} // namespace core
