#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

/// Returns a box with the half side lengths `half`, each side a grid of `cuts` by `cuts` squares.
inline core::TriangleMesh gridBox(const core::Vec3& half, int cuts)
{
    core::TriangleMesh mesh;
    std::map<std::tuple<int, int, int>, core::Slot> slots;
    const auto vertex = [&](std::array<int, 3> at) {
        const auto [entry, isNew] = slots.try_emplace({at[0], at[1], at[2]}, static_cast<core::Slot>(slots.size()));
        const core::Vec3 share = core::Vec3(at[0], at[1], at[2]) / cuts;
        if (isNew)
            mesh.points.push_back(half.cwiseProduct(share).cast<float>());
        return entry->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-cuts, cuts})
            for (int i = -cuts; i < cuts; i += 2)
                for (int j = -cuts; j < cuts; j += 2) {
                    const auto corner = [&](int di, int dj) {
                        std::array<int, 3> at{};
                        at[static_cast<std::size_t>(axis)] = side;
                        at[static_cast<std::size_t>((axis + 1) % 3)] = i + di;
                        at[static_cast<std::size_t>((axis + 2) % 3)] = j + dj;
                        return vertex(at);
                    };
                    const core::Slot a = corner(0, 0), b = corner(2, 0), c = corner(2, 2), d = corner(0, 2);
                    if (side > 0)
                        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
                    else
                        mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, d, c}});
                }
    return mesh;
}

/// Returns the solid of revolution of a profile about the y axis. `line`: the profile's (radius, y) points from bottom
/// to top; the first and the last have radius 0.
inline core::TriangleMesh turned(const std::vector<std::pair<double, double>>& line, int sectors)
{
    core::TriangleMesh mesh;
    const std::size_t rings = line.size() - 2;
    const auto at = [&](std::size_t ring, int sector) {
        return static_cast<core::Slot>(1 + (ring - 1) * static_cast<std::size_t>(sectors) +
                                       static_cast<std::size_t>(sector % sectors));
    };
    mesh.points.emplace_back(0.0F, static_cast<float>(line.front().second), 0.0F);
    for (std::size_t ring = 1; ring <= rings; ++ring)
        for (int s = 0; s < sectors; ++s) {
            const double angle = 2 * std::numbers::pi * s / sectors, radius = line[ring].first;
            mesh.points.push_back(
                core::Vec3(radius * std::sin(angle), line[ring].second, radius * std::cos(angle)).cast<float>());
        }
    mesh.points.emplace_back(0.0F, static_cast<float>(line.back().second), 0.0F);
    const auto top = static_cast<core::Slot>(mesh.points.size() - 1);
    for (int s = 0; s < sectors; ++s) {
        mesh.triangles.push_back({0, at(1, s + 1), at(1, s)});
        for (std::size_t ring = 1; ring < rings; ++ring) {
            mesh.triangles.push_back({at(ring, s), at(ring, s + 1), at(ring + 1, s + 1)});
            mesh.triangles.push_back({at(ring, s), at(ring + 1, s + 1), at(ring + 1, s)});
        }
        mesh.triangles.push_back({top, at(rings, s), at(rings, s + 1)});
    }
    return mesh;
}
