#include "clay.h"

#include "shapes.h"

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
            if (r % 2 == 0) { // the ring above stands half a step on
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
    for (int i = 0; i <= steps; ++i) { // outside, up
        const double a = 0.5 * std::numbers::pi * i / steps;
        profile.emplace_back(std::sin(a), -std::cos(a), 0);
    }
    for (int i = steps; i >= 0; --i) { // inside, down
        const double a = 0.5 * std::numbers::pi * i / steps;
        profile.emplace_back(0.85 * std::sin(a), -0.85 * std::cos(a) + 0.02, 0);
    }
    profile.front().x() = profile.back().x() = 0;
    return revolved(profile, 32);
}

TriangleMesh twoFingers(double gap)
{
    TriangleMesh one = core::icosphere(3, 1);
    for (core::Vec3f& p : one.points)
        p = {0.35f * p.x(), p.y(), 0.35f * p.z()};
    const float offset = static_cast<float>(0.35 + gap / 2);
    return shapes::together(shapes::moved(one, {-offset, 0, 0}), shapes::moved(one, {offset, 0, 0}));
}
} // namespace clay
