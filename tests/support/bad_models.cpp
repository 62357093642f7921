#include "tests/support/bad_models.h"

#include "tests/support/shapes.h"

#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace
{
using namespace core;

TriangleMesh ball()
{
    return icosphere(4, 50);
}

TriangleMesh withHoles()
{
    TriangleMesh mesh = ball();
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        const Vec3f p = mesh.points[t[0]];
        return (p - Vec3f(50, 0, 0)).norm() < 8 || (p - Vec3f(0, 45, 20)).norm() < 9;
    });
    return mesh;
}

TriangleMesh flippedFaces()
{
    TriangleMesh mesh = ball();
    for (std::size_t f = 0; f < mesh.triangles.size(); f += 3)
        std::swap(mesh.triangles[f][0], mesh.triangles[f][1]);
    return mesh;
}

/// Returns two cubes whose common vertices (an edge or a corner, depending on `offset`) are shared by index.
TriangleMesh cubesSharing(const Vec3f& offset)
{
    TriangleMesh mesh = shapes::together(shapes::cube(40), shapes::moved(shapes::cube(40), offset));
    for (Slot v = 8; v < 16; ++v)
        for (Slot w = 0; w < 8; ++w)
            if (mesh.points[v] == mesh.points[w])
                for (Triangle& t : mesh.triangles)
                    std::ranges::replace(t, v, w);
    return mesh;
}

TriangleMesh duplicateFaces()
{
    TriangleMesh mesh = ball();
    const std::size_t faces = mesh.triangles.size();
    for (std::size_t f = 0; f < faces; f += 5)
        mesh.triangles.push_back({mesh.triangles[f][1], mesh.triangles[f][2], mesh.triangles[f][0]});
    for (std::size_t f = 0; f < faces; f += 7)
        mesh.triangles.push_back({mesh.triangles[f][1], mesh.triangles[f][0], mesh.triangles[f][2]});
    return mesh;
}

/// Returns a tube along a (p, q) torus knot. Neighbouring turns overlap because the tube is wider than their distance.
TriangleMesh knot(int p, int q, double tube)
{
    constexpr Slot along = 240, around = 16;
    TriangleMesh mesh;
    const auto centre = [&](double t) {
        const double r = 30 + 15 * std::cos(q * t);
        return Vec3(r * std::cos(p * t), 15 * std::sin(q * t), r * std::sin(p * t));
    };
    for (Slot i = 0; i < along; ++i) {
        const double t = 2 * std::numbers::pi * i / along;
        const Vec3 c = centre(t), tangent = (centre(t + 1e-4) - centre(t - 1e-4)).normalized();
        const Vec3 outwards = Vec3(c.x(), 0, c.z()).normalized();
        const Vec3 u = (outwards - outwards.dot(tangent) * tangent).normalized(), v = tangent.cross(u);
        for (Slot k = 0; k < around; ++k) {
            const double a = 2 * std::numbers::pi * k / around;
            mesh.points.push_back((c + tube * (std::cos(a) * u + std::sin(a) * v)).cast<float>());
        }
    }
    for (Slot i = 0; i < along; ++i) {
        for (Slot k = 0; k < around; ++k) {
            const Slot j = (i + 1) % along, l = (k + 1) % around;
            const Slot a = i * around + k, b = j * around + k, c = j * around + l, d = i * around + l;
            mesh.triangles.push_back({a, d, c});
            mesh.triangles.push_back({a, c, b});
        }
    }
    return mesh;
}

/// Returns the triangles of a ball, unconnected, each corner displaced by up to `farthest` along each axis.
TriangleMesh soup(float farthest)
{
    const TriangleMesh whole = icosphere(3, 50);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> off(-farthest, farthest);
    TriangleMesh mesh;
    for (const Triangle& t : whole.triangles) {
        const auto first = static_cast<Slot>(mesh.points.size());
        for (const Slot v : t)
            mesh.points.push_back(whole.points[v] + Vec3f(off(random), off(random), off(random)));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// Returns two unconnected halves of a ball, one of them displaced by a few micrometres.
TriangleMesh crackedSeam()
{
    TriangleMesh upper = ball(), lower = upper;
    const auto isUp = [&](const Triangle& t) { return lower.points[t[0]].y() > 0; };
    std::erase_if(upper.triangles, [&](const Triangle& t) { return !isUp(t); });
    std::erase_if(lower.triangles, isUp);
    return shapes::together(upper, shapes::moved(lower, Vec3f(0.004f, -0.003f, 0.002f)));
}

/// Returns crackedSeam(), in which one half has an extra vertex in the middle of each edge at the crack.
TriangleMesh tJunctions()
{
    TriangleMesh mesh = crackedSeam();
    std::set<std::pair<Slot, Slot>> ways;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            ways.emplace(t[i], t[(i + 1) % 3]);
    const std::size_t faces = mesh.triangles.size();
    for (std::size_t f = 0; f < faces; ++f) {
        const Triangle t = mesh.triangles[f];
        if (mesh.points[t[0]].y() <= 0)
            continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const Slot a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
            if (ways.contains({b, a}))
                continue;
            const auto middle = static_cast<Slot>(mesh.points.size());
            mesh.points.push_back(0.5f * (mesh.points[a] + mesh.points[b]));
            mesh.triangles[f] = {a, middle, c};
            mesh.triangles.push_back({middle, b, c});
            break;
        }
    }
    return mesh;
}

TriangleMesh slivers()
{
    TriangleMesh mesh = ball();
    const std::size_t faces = mesh.triangles.size();
    for (std::size_t f = 0; f < faces;
         f += 11) { // an extra vertex in the middle of one side, and a degenerate face along that side
        const auto [a, b, c] = mesh.triangles[f];
        const auto m = static_cast<Slot>(mesh.points.size());
        mesh.points.push_back(0.5f * (mesh.points[a] + mesh.points[b]));
        mesh.triangles[f] = {a, m, c};
        mesh.triangles.push_back({m, b, c});
        mesh.triangles.push_back({a, b, m});
    }
    for (std::size_t f = 0; f < faces; f += 13)
        mesh.triangles.push_back({mesh.triangles[f][0], mesh.triangles[f][0], mesh.triangles[f][1]});
    return mesh;
}

TriangleMesh openBowl()
{
    TriangleMesh mesh = ball();
    std::erase_if(mesh.triangles, [&](const Triangle& t) { return mesh.points[t[0]].y() > 10; });
    return mesh;
}

TriangleMesh membrane()
{
    TriangleMesh mesh = shapes::cube(60);
    const auto find = [&](const Vec3f& way) {
        Slot best = 0;
        for (Slot v = 0; v < 8; ++v)
            if (mesh.points[v].dot(way) > mesh.points[best].dot(way))
                best = v;
        return best;
    };
    const Slot a = find({-1, -1, -1}), b = find({1, -1, -1}), c = find({1, 1, 1}), d = find({-1, 1, 1});
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
    return mesh;
}
} // namespace

std::vector<BadModel> badModels()
{
    using namespace shapes;
    const TriangleMesh crossing = together(ball(), moved(ball(), Vec3f(45, 20, 5)));
    return {{"holes", withHoles()},
            {"flipped faces", flippedFaces()},
            {"inside out", reversed(ball())},
            {"non-manifold edge", cubesSharing({40, 40, 0})},
            {"non-manifold vertex", cubesSharing({40, 40, 40})},
            {"bow tie", scaled(bowTie(), 40)},
            {"duplicate faces", duplicateFaces()},
            {"inner shells", together(ball(), together(icosphere(3, 20), moved(icosphere(2, 5), Vec3f(35, 0, 0))))},
            {"torus knot", knot(2, 3, 14)},
            {"winding torus knot", knot(3, 7, 7)},
            {"soup", soup(0.4f)},
            {"coplanar overlap", together(cube(40), moved(cube(40), Vec3f(20, 10, 0)))},
            {"stacked cubes", together(cube(40), moved(cube(40), Vec3f(10, 40, 10)))},
            {"slivers", slivers()},
            {"crossing shells", crossing},
            {"open bowl", openBowl()},
            {"membrane", membrane()},
            {"crossing cubes", together(cube(40), moved(cube(40), Vec3f(20, 20, 20)))},
            {"touching cubes", scaled(touchingCubes(), 20)},
            {"cracked everywhere", soup(0.003f)},
            {"cracked seam", crackedSeam()},
            {"T junctions", tJunctions()},
            {"three faces at an edge", scaled(threeFacesAtEdge(), 40)}};
}
