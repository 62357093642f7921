#include "vr/sculpt/tube_drawing.h"

#include "core/primitives/tube_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vr
{
namespace
{
using core::TubePoint;
using core::Vec3;

constexpr double minStep = 0.1;   ///< between points of the path, radii of the tube
constexpr double tolerance = 0.1; ///< distance by which the tube may leave the path, radii of the tube
constexpr int tubeRingEdges = 16, maxRings = 20;
constexpr double ringDistance = 1; ///< at least, radii of the tube

double distance(const TubePoint& a, const TubePoint& b)
{
    return (a.position - b.position).norm();
}

/// Adds a circle around the tube, in room space. `along`: direction of the path, unit length.
void addRing(const TubePoint& point, const Vec3& along, const ModelPlacement& placement, std::vector<Segment>& outline)
{
    const Vec3 x = point.radius * along.unitOrthogonal(), y = along.cross(x);
    const auto at = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / tubeRingEdges;
        return placement.toRoom(point.position + std::cos(angle) * x + std::sin(angle) * y);
    };
    for (int i = 0; i < tubeRingEdges; ++i)
        outline.push_back({at(i), at(i + 1)});
}
} // namespace

void TubeDrawing::begin()
{
    m_isDrawing = true;
    m_path.clear();
    m_step = minStep;
}

void TubeDrawing::add(const TubePoint& point)
{
    const std::size_t count = m_path.size();
    if (count > 1 && distance(m_path[count - 2], m_path[count - 1]) < m_step * point.radius)
        m_path.pop_back();
    else if (count == maxPoints) {
        std::size_t kept = 1;
        for (std::size_t i = 2; i < count; i += 2)
            m_path[kept++] = m_path[i];
        m_path.resize(kept);
        m_step *= 2;
    }
    m_path.push_back(point);
}

double TubeDrawing::length() const
{
    double length = 0;
    for (std::size_t i = 1; i < m_path.size(); ++i)
        length += distance(m_path[i - 1], m_path[i]);
    return length;
}

std::optional<core::Primitive> TubeDrawing::end(const ModelPlacement& placement)
{
    m_isDrawing = false;
    if (m_path.size() < 2 || placement.lengthToRoom(length()) < minLength)
        return std::nullopt;
    core::Primitive tube;
    tube.kind = core::Primitive::Kind::Tube;
    double most = tolerance * std::ranges::min(m_path, {}, &TubePoint::radius).radius;
    do {
        tube.path = core::thinnedPath(m_path, most);
        most *= 2;
    } while (tube.path.size() > core::PrimitiveLimits::maxProfile);
    const bool isBall =
        tube.path.size() == 2 && placement.lengthToRoom(distance(tube.path.front(), tube.path.back())) < minLength;
    return isBall ? std::nullopt : std::optional(tube);
}

void TubeDrawing::outlineTo(const ModelPlacement& placement, std::vector<Segment>& outline) const
{
    outline.clear();
    if (m_path.size() < 2)
        return;
    const double apart = length() / maxRings;
    double sinceRing = INFINITY;
    for (std::size_t i = 0; i + 1 < m_path.size(); ++i) {
        const double step = distance(m_path[i], m_path[i + 1]);
        if (sinceRing >= std::max(apart, ringDistance * m_path[i].radius) && step > 0) {
            addRing(m_path[i], (m_path[i + 1].position - m_path[i].position) / step, placement, outline);
            sinceRing = 0;
        }
        sinceRing += step;
    }
    const TubePoint& last = m_path.back();
    const Vec3 way = last.position - m_path[m_path.size() - 2].position;
    if (way.norm() > 0)
        addRing(last, way.normalized(), placement, outline);
    const std::vector<TubePoint> middle = core::thinnedPath(m_path, tolerance * last.radius);
    for (std::size_t i = 1; i < middle.size(); ++i)
        outline.push_back({placement.toRoom(middle[i - 1].position), placement.toRoom(middle[i].position)});
}
} // namespace vr
