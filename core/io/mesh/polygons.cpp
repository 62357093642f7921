#include "core/io/mesh/polygons.h"

#include "core/io/mesh/ear_clipping.h"
#include "core/io/mesh/flat_polygon.h"

#include <cassert>

namespace core::io
{
namespace
{
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

/// Removes corners of a polygon that equal the preceding one, and slits: paths that lead to a point and straight back.
class CleanRing
{
public:
    CleanRing(const std::vector<Vec3f>& points, std::span<const Slot> corners) : m_points(points)
    {
        for (const Slot corner : corners) {
            m_ring.push_back(corner);
            while (dropLast()) {
            }
        }
        while (dropAcrossEnds()) {
        }
    }

    /// Returns whether there is anything to remove. Most polygons need no change.
    static bool isNeeded(const std::vector<Vec3f>& points, std::span<const Slot> corners)
    {
        const std::size_t n = corners.size();
        for (std::size_t i = 0; i < n; ++i)
            for (const std::size_t further : {i + 1, i + 2})
                if (areSame(points, corners[i], corners[further % n]))
                    return true;
        return false;
    }

    std::span<const Slot> corners() const { return std::span(m_ring).subspan(m_first); }

private:
    static bool areSame(const std::vector<Vec3f>& points, Slot a, Slot b) { return a == b || points[a] == points[b]; }
    bool areSame(std::size_t i, std::size_t k) const { return areSame(m_points, m_ring[i], m_ring[k]); }

    bool dropLast()
    {
        const std::size_t n = m_ring.size();
        const bool isDouble = n >= 2 && areSame(n - 1, n - 2), isTip = !isDouble && n >= 3 && areSame(n - 1, n - 3);
        m_ring.resize(n - (isDouble ? 1 : isTip ? 2 : 0));
        return isDouble || isTip;
    }

    bool dropAcrossEnds()
    {
        const std::size_t left = m_ring.size() - m_first, last = m_ring.size() - 1;
        const bool isDouble = left >= 2 && areSame(m_first, last), couldHaveTip = !isDouble && left >= 3,
                   isLastTip = couldHaveTip && areSame(m_first, last - 1),
                   isFirstTip = couldHaveTip && !isLastTip && areSame(m_first + 1, last);
        m_first += isFirstTip ? 1 : 0;
        m_ring.resize(m_ring.size() - (isDouble || isLastTip || isFirstTip ? 1 : 0));
        return isDouble || isLastTip || isFirstTip;
    }

    const std::vector<Vec3f>& m_points;
    std::vector<Slot> m_ring;
    std::size_t m_first = 0; ///< index of the ring's first corner
};
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
        clipEars(triangles, points, corners, stopCheck);
}

std::vector<Triangle> Polygons::triangles(const std::vector<Vec3f>& points, StopCheck stopCheck,
                                          ReadRemarks& remarks) const
{
    std::vector<Triangle> result;
    result.reserve(m_corners.size() - 2 * m_ends.size());
    std::size_t first = 0;
    for (const std::size_t end : m_ends) {
        stopCheck();
        const auto corners = std::span(m_corners).subspan(first, end - first);
        first = end;
        if (corners.size() == 3) { // the most frequent case
            result.push_back({corners[0], corners[1], corners[2]});
        } else if (!CleanRing::isNeeded(points, corners)) {
            appendPolygon(result, points, corners, stopCheck);
        } else {
            const CleanRing ring(points, corners);
            remarks.repeatedCorners += corners.size() - ring.corners().size();
            if (ring.corners().size() < 3)
                ++remarks.facesOfFewer;
            else
                appendPolygon(result, points, ring.corners(), stopCheck);
        }
    }
    return result;
}
} // namespace core::io
