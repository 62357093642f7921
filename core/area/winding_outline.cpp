// Finds the outline of the area within a closed curve:
//   1. cut      segments where they meet, until they only meet at their ends
//   2. select   segments with a winding number of zero on one side only
//   3. trace    loops along them, area on the left
//   4. part     loops that touch in a point
//   5. drop     loops that are too thin

#include "core/area/winding_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace core
{
namespace
{
constexpr int maxRounds = 40;
/// Distance by which a loop is drawn back from a point where it touches itself or another.
constexpr double drawnBack = 16;
/// Least mean width of a loop: twice its area divided by its length.
constexpr double minWidth = 4;

using Point = std::array<int, 2>;

std::int64_t cross(const Point& a, const Point& b, const Point& c)
{
    return std::int64_t(b[0] - a[0]) * (c[1] - a[1]) - std::int64_t(b[1] - a[1]) * (c[0] - a[0]);
}

int signOf(std::int64_t x)
{
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// Returns whether c, which is on the line through a and b, is between them.
bool isBetween(const Point& a, const Point& b, const Point& c)
{
    return c != a && c != b && std::min(a, b) < c && c < std::max(a, b);
}

/// A segment from the lesser to the greater end, and how many times more the curve runs that way than back.
struct Segment
{
    Point from, to;
    int times = 0;
};

class SegmentSet
{
public:
    explicit SegmentSet(std::span<const FlatPoint> curve);

    bool cutAll();
    std::map<Point, std::vector<Point>> outline() const;

private:
    using Cuts = std::vector<std::vector<Point>>;

    static void meet(std::size_t first, std::size_t second, const std::vector<Segment>& segments, Cuts& cuts);
    void add(const Point& from, const Point& to, int times);
    std::vector<Segment> segments() const;

    std::map<std::array<Point, 2>, int> m_times;
};

SegmentSet::SegmentSet(std::span<const FlatPoint> curve)
{
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const FlatPoint& p = curve[i];
        const FlatPoint& q = curve[(i + 1) % curve.size()];
        add({p.x(), p.y()}, {q.x(), q.y()}, 1);
    }
}

void SegmentSet::add(const Point& from, const Point& to, int times)
{
    if (from == to)
        return;
    const bool isTurned = to < from;
    m_times[isTurned ? std::array{to, from} : std::array{from, to}] += isTurned ? -times : times;
}

std::vector<Segment> SegmentSet::segments() const
{
    std::vector<Segment> result;
    for (const auto& [ends, times] : m_times) {
        if (times != 0)
            result.push_back({ends[0], ends[1], times});
    }
    return result;
}

/// Notes the points at which two segments must be cut.
void SegmentSet::meet(std::size_t first, std::size_t second, const std::vector<Segment>& segments, Cuts& cuts)
{
    const auto& [a, b, timesAb] = segments[first];
    const auto& [c, d, timesCd] = segments[second];
    const std::int64_t atC = cross(a, b, c), atD = cross(a, b, d), atA = cross(c, d, a), atB = cross(c, d, b);
    const auto cutAt = [&](std::size_t segment, const Point& p) {
        if (p != segments[segment].from && p != segments[segment].to)
            cuts[segment].push_back(p);
    };
    if (signOf(atC) * signOf(atD) < 0 && signOf(atA) * signOf(atB) < 0) {
        const double share = static_cast<double>(atA) / static_cast<double>(atA - atB);
        const Point p = {static_cast<int>(std::lround(a[0] + share * (b[0] - a[0]))),
                         static_cast<int>(std::lround(a[1] + share * (b[1] - a[1])))};
        cutAt(first, p);
        cutAt(second, p);
        return;
    }
    for (const auto& [p, at] : {std::pair(c, atC), std::pair(d, atD)}) {
        if (at == 0 && isBetween(a, b, p))
            cutAt(first, p);
    }
    for (const auto& [p, at] : {std::pair(a, atA), std::pair(b, atB)}) {
        if (at == 0 && isBetween(c, d, p))
            cutAt(second, p);
    }
}

/// Cuts segments until they only meet at their ends. Returns whether that came to an end.
bool SegmentSet::cutAll()
{
    for (int round = 0; round < maxRounds; ++round) {
        const std::vector<Segment> all = segments(); // ascending by the lesser x
        Cuts cuts(all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto [low, high] = std::minmax(all[i].from[1], all[i].to[1]);
            for (std::size_t k = i + 1; k < all.size() && all[k].from[0] <= all[i].to[0]; ++k) {
                if (std::max(all[k].from[1], all[k].to[1]) >= low && std::min(all[k].from[1], all[k].to[1]) <= high)
                    meet(i, k, all, cuts);
            }
        }
        if (std::ranges::all_of(cuts, [](const auto& cut) { return cut.empty(); }))
            return true;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (cuts[i].empty())
                continue;
            const auto& [from, to, times] = all[i];
            const auto along = [&](const Point& p) {
                return std::int64_t(p[0] - from[0]) * (to[0] - from[0]) +
                       std::int64_t(p[1] - from[1]) * (to[1] - from[1]);
            };
            std::ranges::sort(cuts[i], {}, along);
            m_times.erase({from, to});
            Point last = from;
            for (const Point& p : cuts[i])
                add(std::exchange(last, p), p, times);
            add(last, to, times);
        }
    }
    return false;
}

Point turned(const Point& p)
{
    return {-p[1], p[0]};
}

/// Returns the curve's winding numbers on the left and the right of a segment. Counts the segments that a ray from the
/// segment's middle meets.
std::array<int, 2> windingsBeside(const Segment& segment, const std::vector<Segment>& all)
{
    const bool isLevel = segment.from[1] == segment.to[1];
    const auto placed = [&](const Point& p) { return isLevel ? turned(p) : p; };
    const Point from = placed(segment.from), to = placed(segment.to);
    const Point middle = {from[0] + to[0], from[1] + to[1]}; // in half units
    int winding = 0;
    for (const Segment& other : all) {
        if (other.from == segment.from && other.to == segment.to)
            continue;
        const Point p = placed(other.from), q = placed(other.to);
        const Point a = {2 * p[0], 2 * p[1]}, b = {2 * q[0], 2 * q[1]};
        if ((a[1] <= middle[1]) == (b[1] <= middle[1]))
            continue;
        const bool isUp = b[1] > a[1];
        if ((cross(a, b, middle) > 0) == isUp)
            winding += isUp ? other.times : -other.times;
    }
    return to[1] > from[1] ? std::array{winding + segment.times, winding}
                           : std::array{winding, winding - segment.times};
}

/// Returns the directed segments of the outline: the ends by the starts.
std::map<Point, std::vector<Point>> SegmentSet::outline() const
{
    std::map<Point, std::vector<Point>> result;
    const std::vector<Segment> all = segments();
    for (const Segment& segment : all) {
        const auto [left, right] = windingsBeside(segment, all);
        if (left != 0 && right == 0)
            result[segment.from].push_back(segment.to);
        else if (left == 0 && right != 0)
            result[segment.to].push_back(segment.from);
    }
    return result;
}

double angleOf(const Point& from, const Point& to)
{
    return std::atan2(to[1] - from[1], to[0] - from[0]);
}

/// Returns the angle of the area at a corner of a loop, from 0 to 2 pi: from the segment that ends there clockwise to
/// the one that begins there.
double angleAt(const Point& before, const Point& corner, const Point& after)
{
    const double angle = angleOf(corner, before) - angleOf(corner, after);
    return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

/// Takes the segments apart into loops. At a point with several, follows the border of the same part of the area.
std::vector<std::vector<Point>> loopsOf(std::map<Point, std::vector<Point>> segments)
{
    std::vector<std::vector<Point>> loops;
    while (!segments.empty()) {
        const Point start = segments.begin()->first;
        std::vector<Point> loop;
        Point before = start, corner = start;
        for (auto found = segments.begin(); found != segments.end(); found = segments.find(corner)) {
            std::vector<Point>& ends = found->second;
            const auto next = loop.empty() ? ends.begin() : std::ranges::min_element(ends, {}, [&](const Point& end) {
                return angleAt(before, corner, end);
            });
            loop.push_back(corner);
            before = std::exchange(corner, *next);
            ends.erase(next);
            if (ends.empty())
                segments.erase(found);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

/// Draws the loops back from points that they pass more than once.
std::vector<FlatLoop> parted(const std::vector<std::vector<Point>>& loops)
{
    std::map<Point, int> passes;
    for (const auto& loop : loops)
        for (const Point& p : loop)
            ++passes[p];
    std::vector<FlatLoop> result;
    for (const auto& loop : loops) {
        FlatLoop& flat = result.emplace_back();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point& p = loop[i];
            flat.emplace_back(p[0], p[1]);
            if (passes[p] == 1)
                continue;
            const Point& before = loop[(i + loop.size() - 1) % loop.size()];
            const double middle = angleOf(p, before) - angleAt(before, p, loop[(i + 1) % loop.size()]) / 2;
            flat.back() += FlatPoint(static_cast<int>(std::lround(drawnBack * std::cos(middle))),
                                     static_cast<int>(std::lround(drawnBack * std::sin(middle))));
        }
    }
    return result;
}

bool isThin(const FlatLoop& loop)
{
    double area = 0, length = 0; // area: twice
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Eigen::Vector2d p = loop[i].cast<double>(), q = loop[(i + 1) % loop.size()].cast<double>();
        area += p.x() * q.y() - p.y() * q.x();
        length += (q - p).norm();
    }
    return std::abs(area) < minWidth * length;
}
} // namespace

std::vector<FlatLoop> windingOutline(std::span<const FlatPoint> curve)
{
    SegmentSet segments(curve);
    if (!segments.cutAll())
        return {};
    std::vector<FlatLoop> loops = parted(loopsOf(segments.outline()));
    std::erase_if(loops, isThin);
    return loops;
}
} // namespace core
