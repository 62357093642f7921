#pragma once

#include "geometry.h"

#include <vector>

namespace core
{
/// Points in cells of one size, for questions about what lies near: O(1) a point, O(what is near) a question.
class ProximityGrid
{
public:
    /// `reach` > 0: the largest distance that can be asked about.
    ProximityGrid(const std::vector<Vec3>& points, double reach);

    /// Calls visit(i) for every point in the 27 cells around p: all within reach, and some more. In no useful order.
    template <class Visit> void forEachNear(const Vec3& p, Visit visit) const
    {
        const Cell center = cellOf(p);
        for (std::int64_t z = center.z() - 1; z <= center.z() + 1; ++z) {
            for (std::int64_t y = center.y() - 1; y <= center.y() + 1; ++y) {
                for (std::int64_t x = center.x() - 1; x <= center.x() + 1; ++x)
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

    Cell cellOf(const Vec3& p) const
    {
        return (p.array() * m_perReach).floor().cast<std::int64_t>().matrix();
    }
    std::size_t bucketOf(const Cell& cell) const;
    template <class Visit> void visitCell(const Cell& cell, Visit& visit) const
    {
        for (Slot i = m_buckets[bucketOf(cell)]; i != noSlot; i = m_entries[i].next) {
            if (m_entries[i].cell == cell)
                visit(i);
        }
    }

    double m_perReach;
    std::vector<Slot> m_buckets; ///< a power of two
    std::vector<Entry> m_entries;
};
} // namespace core
