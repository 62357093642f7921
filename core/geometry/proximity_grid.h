#pragma once

#include "core/geometry/geometry.h"

#include <span>
#include <vector>

namespace core
{
/// Keeps points in cells of one size, to find those in a box: O(1) a point, O(what is near) a question.
class ProximityGrid
{
public:
    /// `reach` > 0: half the side of the largest box that is asked about, or about that. A cell is two reaches long, or
    /// less where points lie closely.
    ProximityGrid(const std::vector<Vec3>& points, double reach);

    /// Returns the number of cells that are not empty.
    std::size_t cells() const { return m_cells.size(); }
    /// Returns the points in one of them, ascending.
    std::span<const Slot> pointsIn(std::size_t cell) const
    {
        return std::span(m_points).subspan(m_cells[cell].first, m_cells[cell].count);
    }

    /// Calls visit(cell) for every cell that is not empty and meets the box. In no useful order.
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
    /// Calls visit(i) for every point within reach of p, and some more. In no useful order.
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
        Slot next = noSlot; ///< in the same bucket
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
    std::vector<Slot> m_buckets; ///< a power of two
    std::vector<Cell> m_cells;
    std::vector<Slot> m_points; ///< by cell
};
} // namespace core
