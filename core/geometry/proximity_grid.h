#pragma once

#include "core/geometry/geometry.h"

#include <vector>

namespace core
{
/// Points in cells of one size, for questions about what lies near: O(1) a point, O(what is near) a question.
class ProximityGrid
{
public:
    /// `reach` > 0: the largest distance that can be asked about.
    ProximityGrid(const std::vector<Vec3>& points, double reach);

    /// Calls visit(i) for every point in the eight cells nearest to p: all within reach, and some more. In no useful
    /// order.
    template <class Visit> void forEachNear(const Vec3& p, Visit visit) const
    {
        const Cell first = cellAt(m_perCell * p.array() - 0.5);
        for (std::int64_t z = first.z(); z <= first.z() + 1; ++z) {
            for (std::int64_t y = first.y(); y <= first.y() + 1; ++y) {
                for (std::int64_t x = first.x(); x <= first.x() + 1; ++x)
                    visitCell({x, y, z}, visit);
            }
        }
    }

private:
    using Cell = Eigen::Matrix<std::int64_t, 3, 1>;
    struct Entry
    {
        Cell cell;
        Slot next;
    };

    static Cell cellAt(const Eigen::Array3d& place) { return place.floor().cast<std::int64_t>().matrix(); }
    std::size_t bucketOf(const Cell& cell) const;
    template <class Visit> void visitCell(const Cell& cell, Visit& visit) const
    {
        for (Slot i = m_buckets[bucketOf(cell)]; i != noSlot; i = m_entries[i].next) {
            if (m_entries[i].cell == cell)
                visit(i);
        }
    }

    double m_perCell;            ///< a cell is two reaches long
    std::vector<Slot> m_buckets; ///< a power of two
    std::vector<Entry> m_entries;
};
} // namespace core
