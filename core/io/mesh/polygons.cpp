#include "core/io/mesh/polygons.h"

#include "core/geometry/predicates.h"

#include <algorithm>
#include <cassert>

namespace core::io
{
namespace
{
/// A polygon seen along the axis in which its area is largest. Its sense: 1 if counter-clockwise there, else -1.
class FlatPolygon
{
public:
    FlatPolygon(const std::vector<Vec3f>& points, std::span<const Slot> corners) : m_points(points)
    {
        Vec3 area = Vec3::Zero();
        const Vec3 origin = point(corners[0]);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            area += (point(corners[i]) - origin).cross(point(corners[i + 1]) - origin);
        area.cwiseAbs().maxCoeff(&m_axis);
        m_sense = area[m_axis] < 0 ? -1 : 1;
    }

    /// 1 if the path a, b, c turns as the polygon does, -1 against it, 0 straight. Exact.
    int turn(Slot a, Slot b, Slot c) const
    {
        return m_sense * FloatPredicates::orient2d(m_points[a], m_points[b], m_points[c], m_axis);
    }

    double squaredDistance(Slot a, Slot b) const { return (point(a) - point(b)).squaredNorm(); }

private:
    Vec3 point(Slot corner) const { return m_points[corner].cast<double>(); }

    const std::vector<Vec3f>& m_points;
    int m_axis = 0;
    int m_sense = 1;
};

void appendQuad(std::vector<Triangle>& triangles, const FlatPolygon& polygon, std::span<const Slot> c)
{
    const bool firstWorks = polygon.turn(c[0], c[1], c[2]) > 0 && polygon.turn(c[0], c[2], c[3]) > 0;
    const bool secondWorks = polygon.turn(c[1], c[2], c[3]) > 0 && polygon.turn(c[1], c[3], c[0]) > 0;
    const bool firstShorter = polygon.squaredDistance(c[0], c[2]) <= polygon.squaredDistance(c[1], c[3]);
    if (firstWorks == secondWorks ? firstShorter : firstWorks) {
        triangles.push_back({c[0], c[1], c[2]});
        triangles.push_back({c[0], c[2], c[3]});
    } else {
        triangles.push_back({c[1], c[2], c[3]});
        triangles.push_back({c[1], c[3], c[0]});
    }
}

/// Is the corner at i convex, and is no other corner in the triangle it would cut off?
bool isEar(const FlatPolygon& polygon, const std::vector<Slot>& ring, std::size_t i)
{
    const std::size_t n = ring.size();
    const Slot a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
    if (polygon.turn(a, b, c) <= 0)
        return false;
    return std::none_of(ring.begin(), ring.end(), [&](Slot p) {
        return p != a && p != b && p != c && polygon.turn(a, b, p) >= 0 && polygon.turn(b, c, p) >= 0 &&
               polygon.turn(c, a, p) >= 0;
    });
}

void clipEars(std::vector<Triangle>& triangles, const FlatPolygon& polygon, std::vector<Slot> ring,
              StopCheck& stopCheck)
{
    std::size_t i = 0, tried = 0;
    bool simple = true; // until no ear is left: a simple polygon always has one
    while (ring.size() > 3) {
        const std::size_t n = ring.size();
        stopCheck(n);
        simple = simple && tried < n;
        if (simple && !isEar(polygon, ring, i)) {
            i = (i + 1) % n;
            ++tried;
            continue;
        }
        triangles.push_back({ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
        i = i == ring.size() ? 0 : (i + 1) % ring.size(); // one further: a fan would give slivers
        tried = 0;
    }
    triangles.push_back({ring[0], ring[1], ring[2]});
}
} // namespace

void appendPolygon(std::vector<Triangle>& triangles, const std::vector<Vec3f>& points, std::span<const Slot> corners,
                   StopCheck& stopCheck)
{
    assert(corners.size() >= 3);
    stopCheck();
    if (corners.size() == 3) {
        triangles.push_back({corners[0], corners[1], corners[2]});
        return;
    }
    const FlatPolygon polygon(points, corners);
    if (corners.size() == 4)
        appendQuad(triangles, polygon, corners);
    else
        clipEars(triangles, polygon, {corners.begin(), corners.end()}, stopCheck);
}

std::vector<Triangle> Polygons::triangles(const std::vector<Vec3f>& points, StopCheck stopCheck) const
{
    std::vector<Triangle> result;
    result.reserve(m_corners.size() - 2 * m_ends.size());
    std::size_t first = 0;
    for (const std::size_t end : m_ends) {
        stopCheck();
        if (end - first == 3) // most are
            result.push_back({m_corners[first], m_corners[first + 1], m_corners[first + 2]});
        else
            appendPolygon(result, points, std::span(m_corners).subspan(first, end - first), stopCheck);
        first = end;
    }
    return result;
}
} // namespace core::io
