// Triangulates a polygon with holes (Eberly 2002, with integers instead of tolerances):
//   1. nest     each hole belongs to the smallest loop around it
//   2. bridge   each hole, from left to right, is joined to its loop by the shortest segment that meets nothing
//   3. clip     ears are cut; every second corner is skipped, so that no corner collects all triangles

#include "core/geometry/polygon_triangulation.h"

#include <algorithm>
#include <numeric>

namespace core
{
namespace
{
using Loop = std::vector<Slot>;

class Filler
{
public:
    explicit Filler(std::span<const FlatPoint> points) : m_points(points) {}

    std::optional<std::vector<Triangle>> fill(std::vector<Loop> loops)
    {
        std::vector<Loop> outer, holes;
        for (Loop& loop : loops) {
            const double area = areaOf(loop);
            if (loop.size() < 3 || area == 0)
                return std::nullopt;
            (area > 0 ? outer : holes).push_back(std::move(loop));
        }
        std::ranges::stable_sort(outer, {}, [this](const Loop& loop) { return areaOf(loop); });
        std::vector<std::vector<Loop>> holesOf(outer.size());
        for (Loop& hole : holes) {
            const auto around =
                std::ranges::find_if(outer, [&](const Loop& loop) { return contains(loop, m_points[hole[0]]); });
            if (around == outer.end())
                return std::nullopt;
            holesOf[static_cast<std::size_t>(around - outer.begin())].push_back(std::move(hole));
        }
        for (std::size_t i = 0; i < outer.size(); ++i)
            if (!bridge(outer[i], std::move(holesOf[i])) || !clip(outer[i]))
                return std::nullopt;
        return std::move(m_triangles);
    }

private:
    const FlatPoint& at(Slot v) const { return m_points[v]; }

    static std::int64_t cross(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c)
    {
        const Eigen::Matrix<std::int64_t, 2, 1> u = (b - a).cast<std::int64_t>(), v = (c - a).cast<std::int64_t>();
        return u.x() * v.y() - u.y() * v.x();
    }
    std::int64_t turn(Slot a, Slot b, Slot c) const { return cross(at(a), at(b), at(c)); }

    /// Returns twice the signed area. The sign is right unless the area is within the rounding error.
    double areaOf(const Loop& loop) const
    {
        double sum = 0;
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            sum += static_cast<double>(turn(loop[0], loop[i], loop[i + 1]));
        return sum;
    }

    /// Returns whether p is inside the loop. Precondition: p is on no side of the loop.
    bool contains(const Loop& loop, const FlatPoint& p) const
    {
        bool isInside = false;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const FlatPoint &a = at(loop[i]), &b = at(loop[(i + 1) % loop.size()]);
            if ((a.y() > p.y()) != (b.y() > p.y()) && (cross(a, b, p) > 0) == (b.y() > a.y()))
                isInside = !isInside;
        }
        return isInside;
    }

    static bool liesBetween(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p)
    {
        return (p.array() >= a.array().min(b.array())).all() && (p.array() <= a.array().max(b.array())).all();
    }

    static bool doMeet(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c, const FlatPoint& d)
    {
        const std::int64_t ac = cross(a, b, c), ad = cross(a, b, d), ca = cross(c, d, a), cb = cross(c, d, b);
        if (((ac > 0 && ad < 0) || (ac < 0 && ad > 0)) && ((ca > 0 && cb < 0) || (ca < 0 && cb > 0)))
            return true;
        return (ac == 0 && liesBetween(a, b, c)) || (ad == 0 && liesBetween(a, b, d)) ||
               (ca == 0 && liesBetween(c, d, a)) || (cb == 0 && liesBetween(c, d, b));
    }

    /// Returns whether the segment pq meets a side of the loop. Sides that end at p or q are ignored.
    bool meetsSideOf(const Loop& loop, const FlatPoint& p, const FlatPoint& q) const
    {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const FlatPoint &a = at(loop[i]), &b = at(loop[(i + 1) % loop.size()]);
            if (a == p || a == q || b == p || b == q)
                continue;
            if (doMeet(p, q, a, b))
                return true;
        }
        return false;
    }

    /// Returns whether p is strictly between the two sides of the loop's corner, on their left.
    bool isInCorner(const Loop& loop, std::size_t corner, const FlatPoint& p) const
    {
        const FlatPoint &a = at(loop[(corner + loop.size() - 1) % loop.size()]), &b = at(loop[corner]),
                        &c = at(loop[(corner + 1) % loop.size()]);
        const bool leftOfIn = cross(a, b, p) > 0, leftOfOut = cross(b, c, p) > 0;
        return cross(a, b, c) > 0 ? leftOfIn && leftOfOut : leftOfIn || leftOfOut;
    }

    std::size_t leftmost(const Loop& loop) const
    {
        const auto key = [this](Slot v) { return std::pair(at(v).x(), at(v).y()); };
        return static_cast<std::size_t>(std::ranges::min_element(loop, {}, key) - loop.begin());
    }

    bool bridge(Loop& loop, std::vector<Loop> holes) const
    {
        std::ranges::sort(holes, {}, [this](const Loop& hole) {
            const FlatPoint& p = at(hole[leftmost(hole)]);
            return std::pair(p.x(), p.y());
        });
        for (std::size_t i = 0; i < holes.size(); ++i) {
            const std::size_t from = leftmost(holes[i]);
            const std::optional<std::size_t> to = cornerInSight(loop, std::span(holes).subspan(i), from);
            if (!to)
                return false;
            Loop joined(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(*to) + 1);
            for (std::size_t k = 0; k <= holes[i].size(); ++k)
                joined.push_back(holes[i][(from + k) % holes[i].size()]);
            joined.insert(joined.end(), loop.begin() + static_cast<std::ptrdiff_t>(*to), loop.end());
            loop = std::move(joined);
        }
        return true;
    }

    /// Returns the nearest corner of the loop from which corner `from` of the first hole is visible.
    std::optional<std::size_t> cornerInSight(const Loop& loop, std::span<const Loop> holes, std::size_t from) const
    {
        const FlatPoint& p = at(holes[0][from]);
        std::vector<std::pair<std::int64_t, std::size_t>> corners;
        for (std::size_t i = 0; i < loop.size(); ++i)
            corners.emplace_back((at(loop[i]) - p).cast<std::int64_t>().squaredNorm(), i);
        std::ranges::sort(corners);
        for (const auto& [distance, corner] : corners) {
            const FlatPoint& q = at(loop[corner]);
            if (distance > 0 && isInCorner(loop, corner, p) && isInCorner(holes[0], from, q) &&
                !meetsSideOf(loop, p, q) &&
                std::ranges::none_of(holes, [&](const Loop& hole) { return meetsSideOf(hole, p, q); }))
                return corner;
        }
        return std::nullopt;
    }

    bool clip(const Loop& loop)
    {
        const auto count = static_cast<Slot>(loop.size());
        /// bent: corners that were not convex at the start; some may have become convex since
        std::vector<Slot> next(count), prev(count), bent;
        for (Slot i = 0; i < count; ++i) {
            next[i] = (i + 1) % count;
            prev[i] = (i + count - 1) % count;
        }
        std::vector<bool> isGone(count, false);
        const auto corner = [&](Slot i) { return turn(loop[prev[i]], loop[i], loop[next[i]]); };
        for (Slot i = 0; i < count; ++i)
            if (corner(i) <= 0)
                bent.push_back(i);
        const auto isEar = [&](Slot i) {
            const FlatPoint &a = at(loop[prev[i]]), &b = at(loop[i]), &c = at(loop[next[i]]);
            if (cross(a, b, c) <= 0)
                return false;
            return std::ranges::none_of(bent, [&](Slot k) {
                const FlatPoint& p = at(loop[k]);
                return !isGone[k] && p != a && p != b && p != c && cross(a, b, p) >= 0 && cross(b, c, p) >= 0 &&
                       cross(c, a, p) >= 0;
            });
        };
        Slot left = count, tried = 0;
        for (Slot i = 0; left > 3;) {
            if (!isEar(i)) {
                if (++tried > left)
                    return false;
                i = next[i];
                continue;
            }
            m_triangles.push_back({loop[prev[i]], loop[i], loop[next[i]]});
            next[prev[i]] = next[i];
            prev[next[i]] = prev[i];
            isGone[i] = true;
            --left;
            tried = 0;
            if (left % 64 == 0)
                std::erase_if(bent, [&](Slot k) { return isGone[k] || corner(k) > 0; });
            i = next[next[i]];
        }
        Slot last = 0;
        while (isGone[last])
            ++last;
        m_triangles.push_back({loop[prev[last]], loop[last], loop[next[last]]});
        return corner(last) > 0;
    }

    std::span<const FlatPoint> m_points;
    std::vector<Triangle> m_triangles;
};
} // namespace

std::optional<std::vector<Triangle>> triangulatePolygon(std::span<const FlatPoint> points,
                                                        std::vector<std::vector<Slot>> loops)
{
    return Filler(points).fill(std::move(loops));
}
} // namespace core
