#include "core/area/area_test.h"

#include <algorithm>
#include <cmath>

namespace core
{
AreaTest::AreaTest(const ViewArea& area) : m_sight(area), m_loops(m_sight.seenCurve(area.outline))
{
    if (!hasArea())
        return;
    double top = -std::numeric_limits<double>::infinity();
    m_bottom = -top;
    std::size_t edges = 0;
    for (const FlatLoop& loop : m_loops.loops()) {
        for (const FlatPoint& p : loop) {
            m_bottom = std::min<double>(m_bottom, p.y());
            top = std::max<double>(top, p.y());
        }
        edges += loop.size();
    }
    m_bands.resize(1 + static_cast<std::size_t>(std::sqrt(edges)));
    m_bandHeight = (top - m_bottom) / static_cast<double>(m_bands.size());
    for (const FlatLoop& loop : m_loops.loops()) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Edge edge{loop[i].cast<double>(), loop[(i + 1) % loop.size()].cast<double>()};
            const auto [low, high] = std::minmax(edge.from.y(), edge.to.y());
            for (std::size_t band = bandOf(low); band <= bandOf(high); ++band)
                m_bands[band].push_back(edge);
        }
    }
}

std::size_t AreaTest::bandOf(double y) const
{
    const double band = std::floor((y - m_bottom) / m_bandHeight);
    return static_cast<std::size_t>(std::clamp(band, 0.0, static_cast<double>(m_bands.size() - 1)));
}

/// Counts the edges to the right of the point: the loops are the borders of the area, so an odd number is inside.
bool AreaTest::isWithin(const Vec3& p) const
{
    const Vec3 seen = m_sight.seen(p);
    if (!hasArea() || (m_sight.isPerspective() && !(seen.z() > 0)))
        return false;
    const Eigen::Vector2d at = m_loops.inUnits(seen.head<2>());
    bool isWithin = false;
    for (const auto& [from, to] : m_bands[bandOf(at.y())]) {
        if ((from.y() <= at.y()) == (to.y() <= at.y()))
            continue;
        const double x = from.x() + (at.y() - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
        isWithin ^= at.x() < x;
    }
    return isWithin;
}
} // namespace core
