#include "vr/scene/solid_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace vr
{
namespace
{
constexpr double smoothCosine = 0.77; ///< faces that meet at less than 40 degrees are shaded as one surface
constexpr int around = 32, rings = 16;

core::Vec3 middleOf(const SolidBuilder::Loop& loop)
{
    return std::accumulate(loop.begin(), loop.end(), core::Vec3(0, 0, 0)) / static_cast<double>(loop.size());
}

std::array<std::int8_t, 4> packed(const core::Vec3& normal)
{
    const auto byte = [](double x) { return static_cast<std::int8_t>(std::lround(127 * x)); };
    return {byte(normal.x()), byte(normal.y()), byte(normal.z()), 0};
}

/// Returns the loop shrunk towards its middle by `by`, metres.
SolidBuilder::Loop inset(const SolidBuilder::Loop& loop, double by)
{
    const core::Vec3 middle = middleOf(loop);
    SolidBuilder::Loop result;
    for (const core::Vec3& point : loop) {
        const core::Vec3 away = point - middle;
        result.push_back(middle + away * std::max(0.0, 1 - by / away.norm()));
    }
    return result;
}

SolidBuilder::Loop atHeight(SolidBuilder::Loop loop, double height)
{
    for (core::Vec3& point : loop)
        point.y() = height;
    return loop;
}
} // namespace

core::Slot SolidBuilder::addPoint(const core::Vec3& point)
{
    m_points.push_back(point);
    return static_cast<core::Slot>(m_points.size() - 1);
}

void SolidBuilder::loft(const std::vector<Loop>& loops)
{
    const auto count = static_cast<core::Slot>(loops.front().size());
    const auto first = static_cast<core::Slot>(m_points.size());
    for (const Loop& loop : loops)
        m_points.insert(m_points.end(), loop.begin(), loop.end());
    const core::Slot start = addPoint(middleOf(loops.front())), end = addPoint(middleOf(loops.back()));
    const auto last = first + static_cast<core::Slot>(loops.size() - 1) * count;
    for (core::Slot i = 0; i < count; ++i) {
        const core::Slot next = (i + 1) % count;
        m_faces.push_back({start, first + i, first + next});
        m_faces.push_back({end, last + next, last + i});
        for (core::Slot ring = first; ring < last; ring += count) {
            m_faces.push_back({ring + i, ring + count + i, ring + count + next});
            m_faces.push_back({ring + i, ring + count + next, ring + next});
        }
    }
}

void SolidBuilder::add(const SolidBuilder& other)
{
    const auto first = static_cast<core::Slot>(m_points.size());
    m_points.insert(m_points.end(), other.m_points.begin(), other.m_points.end());
    for (const core::Triangle& face : other.m_faces)
        m_faces.push_back({first + face[0], first + face[1], first + face[2]});
}

core::DrawArrays SolidBuilder::drawArrays() const
{
    std::vector<core::Vec3> areas;
    std::vector<std::vector<std::size_t>> facesAt(m_points.size());
    for (std::size_t f = 0; f < m_faces.size(); ++f) {
        const core::Triangle& face = m_faces[f];
        const core::Vec3 a = m_points[face[0]];
        areas.push_back((m_points[face[1]] - a).cross(m_points[face[2]] - a));
        for (const core::Slot corner : face)
            facesAt[corner].push_back(f);
    }
    core::DrawArrays arrays;
    std::vector<std::vector<core::Slot>> verticesAt(m_points.size()); // those of a point differ in their normals
    const auto vertexAt = [&](core::Slot point, const std::array<std::int8_t, 4>& normal) {
        for (const core::Slot vertex : verticesAt[point])
            if (arrays.vertices[vertex].normal == normal)
                return vertex;
        const auto vertex = static_cast<core::Slot>(arrays.vertices.size());
        arrays.vertices.push_back({m_points[point].cast<float>(), normal, {255, 255, 255, 255}});
        verticesAt[point].push_back(vertex);
        return vertex;
    };
    for (std::size_t f = 0; f < m_faces.size(); ++f) {
        core::Triangle corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            core::Vec3 normal = core::Vec3::Zero();
            for (const std::size_t other : facesAt[m_faces[f][i]])
                if (areas[f].dot(areas[other]) >= smoothCosine * areas[f].norm() * areas[other].norm())
                    normal += areas[other];
            corners[i] = vertexAt(m_faces[f][i], packed(normal.normalized()));
        }
        arrays.faces.push_back(corners);
    }
    return arrays;
}

SolidBuilder ellipsoid(const core::Vec3& middle, const core::Vec3& half)
{
    std::vector<SolidBuilder::Loop> loops;
    for (int ring = 1; ring < rings; ++ring) {
        const double polar = std::numbers::pi * ring / rings;
        SolidBuilder::Loop loop;
        for (int i = 0; i < around; ++i) {
            const double turn = 2 * std::numbers::pi * i / around;
            const core::Vec3 unit(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
            loop.push_back(middle + half.cwiseProduct(unit));
        }
        loops.push_back(loop);
    }
    SolidBuilder solid;
    solid.loft(loops);
    return solid;
}

SolidBuilder plate(const SolidBuilder::Loop& outline, const PlateHeights& heights)
{
    SolidBuilder solid;
    solid.loft({atHeight(inset(outline, heights.bevel), heights.top), atHeight(outline, heights.top - heights.bevel),
                atHeight(outline, heights.bottom)});
    return solid;
}
} // namespace vr
