#include "tests/support/clay.h"

#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"

#include <cmath>
#include <map>
#include <numbers>

namespace clay
{
using core::Vec3;

TriangleMesh slab(double side, double thickness, Slot cells)
{
    TriangleMesh mesh;
    std::map<std::array<Slot, 3>, Slot> known;
    const auto vertex = [&](Slot x, Slot level, Slot z) {
        const auto [entry, isNew] = known.try_emplace({x, level, z}, static_cast<Slot>(mesh.points.size()));
        if (isNew) {
            const Vec3 p((double(x) / cells - 0.5) * side, (double(level) - 0.5) * thickness,
                         (double(z) / cells - 0.5) * side);
            mesh.points.push_back(p.cast<float>());
        }
        return entry->second;
    };
    const auto quad = [&](Slot a, Slot b, Slot c, Slot d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (Slot i = 0; i < cells; ++i) {
        for (Slot j = 0; j < cells; ++j) {
            quad(vertex(i, 1, j), vertex(i, 1, j + 1), vertex(i + 1, 1, j + 1), vertex(i + 1, 1, j));
            quad(vertex(i, 0, j), vertex(i + 1, 0, j), vertex(i + 1, 0, j + 1), vertex(i, 0, j + 1));
        }
        quad(vertex(i, 0, 0), vertex(i, 1, 0), vertex(i + 1, 1, 0), vertex(i + 1, 0, 0));
        quad(vertex(i, 0, cells), vertex(i + 1, 0, cells), vertex(i + 1, 1, cells), vertex(i, 1, cells));
        quad(vertex(0, 0, i), vertex(0, 0, i + 1), vertex(0, 1, i + 1), vertex(0, 1, i));
        quad(vertex(cells, 0, i), vertex(cells, 1, i), vertex(cells, 1, i + 1), vertex(cells, 0, i + 1));
    }
    return mesh;
}

TriangleMesh revolved(const std::vector<Vec3>& profile, Slot around)
{
    TriangleMesh mesh;
    const Slot rings = static_cast<Slot>(profile.size()) - 2;
    mesh.points.push_back(profile.front().cast<float>());
    for (Slot r = 0; r < rings; ++r) {
        for (Slot i = 0; i < around; ++i) {
            const double a = 2 * std::numbers::pi * (i + 0.5 * (r % 2)) / around;
            const Vec3& p = profile[r + 1];
            mesh.points.push_back(Vec3(p.x() * std::cos(a), p.y(), -p.x() * std::sin(a)).cast<float>());
        }
    }
    mesh.points.push_back(profile.back().cast<float>());
    const Slot top = static_cast<Slot>(mesh.points.size()) - 1;
    const auto vertex = [&](Slot r, Slot i) { return 1 + r * around + i % around; };
    for (Slot i = 0; i < around; ++i) {
        mesh.triangles.push_back({0, vertex(0, i + 1), vertex(0, i)});
        mesh.triangles.push_back({top, vertex(rings - 1, i), vertex(rings - 1, i + 1)});
        for (Slot r = 0; r + 1 < rings; ++r) {
            const Slot a = vertex(r, i), b = vertex(r, i + 1), c = vertex(r + 1, i), d = vertex(r + 1, i + 1);
            if (r % 2 == 0) { // the ring above is rotated by half a step
                mesh.triangles.push_back({a, b, c});
                mesh.triangles.push_back({b, d, c});
            } else {
                mesh.triangles.push_back({a, b, d});
                mesh.triangles.push_back({a, d, c});
            }
        }
    }
    return mesh;
}

TriangleMesh bowl()
{
    std::vector<Vec3> profile;
    constexpr int steps = 8;
    for (int i = 0; i <= steps; ++i) { // outer wall, upwards
        const double a = 0.5 * std::numbers::pi * i / steps;
        profile.emplace_back(std::sin(a), -std::cos(a), 0);
    }
    for (int i = steps; i >= 0; --i) { // inner wall, downwards
        const double a = 0.5 * std::numbers::pi * i / steps;
        profile.emplace_back(0.85 * std::sin(a), -0.85 * std::cos(a) + 0.02, 0);
    }
    profile.front().x() = profile.back().x() = 0;
    return revolved(profile, 32);
}

TriangleMesh tube(const std::vector<Vec3>& path, double radius, Slot around)
{
    struct Ring
    {
        Vec3 center, side;
        double radius;
    };
    constexpr int capRings = 6;
    const auto direction = [&](std::size_t i) {
        return (path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0]).normalized();
    };
    const auto across = [](const Vec3& d) { return Vec3(-d.y(), d.x(), 0); };
    std::vector<Ring> rings;
    const auto addCap = [&](const Vec3& end, const Vec3& outward, const Vec3& side, int first, int step) {
        for (int k = first; k > 0 && k < capRings; k += step) {
            const double a = 0.5 * std::numbers::pi * k / capRings;
            rings.push_back({end + radius * std::cos(a) * outward, side, radius * std::sin(a)});
        }
    };
    const Vec3 startward = direction(0), endward = direction(path.size() - 1);
    addCap(path.front(), -startward, across(startward), 1, 1);
    for (std::size_t i = 0; i < path.size(); ++i)
        rings.push_back({path[i], across(direction(i)), radius});
    addCap(path.back(), endward, across(endward), capRings - 1, -1);

    TriangleMesh mesh;
    for (const Ring& ring : rings) {
        for (Slot i = 0; i < around; ++i) {
            const double a = 2 * std::numbers::pi * i / around;
            mesh.points.push_back(
                (ring.center + ring.radius * (std::cos(a) * ring.side + std::sin(a) * Vec3::UnitZ())).cast<float>());
        }
    }
    const auto vertex = [&](Slot ring, Slot i) { return ring * around + i % around; };
    const Slot start = static_cast<Slot>(mesh.points.size()), last = static_cast<Slot>(rings.size()) - 1;
    mesh.points.push_back((path.front() - radius * startward).cast<float>());
    mesh.points.push_back((path.back() + radius * endward).cast<float>());
    for (Slot i = 0; i < around; ++i) {
        mesh.triangles.push_back({start, vertex(0, i + 1), vertex(0, i)});
        mesh.triangles.push_back({start + 1, vertex(last, i), vertex(last, i + 1)});
        for (Slot r = 0; r < last; ++r) {
            mesh.triangles.push_back({vertex(r, i), vertex(r, i + 1), vertex(r + 1, i + 1)});
            mesh.triangles.push_back({vertex(r, i), vertex(r + 1, i + 1), vertex(r + 1, i)});
        }
    }
    return mesh;
}

TriangleMesh cutRing(double gap)
{
    constexpr double radius = 0.25;
    constexpr int steps = 64;
    const double start = radius + gap / 2; // radians of the arc that a round end and half of the gap occupy
    std::vector<Vec3> path;
    for (int i = 0; i <= steps; ++i) {
        const double a = start + (2 * std::numbers::pi - 2 * start) * i / steps;
        path.emplace_back(std::cos(a), std::sin(a), 0);
    }
    return tube(path, radius, 24);
}

TriangleMesh spiral()
{
    constexpr double radius = 0.12, pitch = 2.1 * radius, inner = 0.35, turns = 2.5;
    constexpr int steps = 100;
    std::vector<Vec3> path;
    for (int i = 0; i <= steps; ++i) {
        const double turn = turns * i / steps, a = 2 * std::numbers::pi * turn, r = inner + pitch * turn;
        path.emplace_back(r * std::cos(a), r * std::sin(a), 0);
    }
    return tube(path, radius, 12);
}

TriangleMesh twoFingers(double gap)
{
    TriangleMesh one = core::icosphere(3, 1);
    for (core::Vec3f& p : one.points)
        p = {0.35f * p.x(), p.y(), 0.35f * p.z()};
    const float offset = static_cast<float>(0.35 + gap / 2);
    return shapes::together(shapes::moved(one, {-offset, 0, 0}), shapes::moved(one, {offset, 0, 0}));
}

std::unique_ptr<core::Sculptor> ball(int subdivisions)
{
    return std::make_unique<core::Sculptor>(mesh_asserts::sculptable(core::icosphere(subdivisions, ballRadius)));
}

std::unique_ptr<core::Sculptor> unitBall()
{
    return std::make_unique<core::Sculptor>(mesh_asserts::sculptable(core::icosphere(4, 1)));
}

core::DabReport dabOnce(core::Sculptor& sculptor, const core::StrokeSettings& settings, const core::Vec3& position,
                        const core::Vec3& direction)
{
    core::StrokeSample sample;
    sample.position = position;
    sample.direction = direction;
    sculptor.beginStroke(settings);
    const core::DabReport report = sculptor.addSample(sample).at(0);
    sculptor.endStroke();
    return report;
}

std::vector<core::DabReport> stroke(core::Sculptor& sculptor, const core::StrokeSettings& settings,
                                    const std::vector<core::Vec3>& path)
{
    std::vector<core::DabReport> reports;
    sculptor.beginStroke(settings);
    for (const core::Vec3& at : path) {
        core::StrokeSample sample;
        sample.position = at;
        sample.direction = -at;
        for (const core::DabReport& report : sculptor.addSample(sample))
            reports.push_back(report);
    }
    sculptor.endStroke();
    return reports;
}
} // namespace clay
