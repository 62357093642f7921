#include "tests/support/shapes.h"

#include "tests/support/stroke_fuzzer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace shapes
{
TriangleMesh tetrahedron()
{
    return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

TriangleMesh cube(float side)
{
    const float h = side / 2;
    return {{{-h, -h, -h}, {h, -h, -h}, {h, h, -h}, {-h, h, -h}, {-h, -h, h}, {h, -h, h}, {h, h, h}, {-h, h, h}},
            {},
            {{0, 2, 1},
             {0, 3, 2},
             {4, 5, 6},
             {4, 6, 7},
             {0, 1, 5},
             {0, 5, 4},
             {1, 2, 6},
             {1, 6, 5},
             {2, 3, 7},
             {2, 7, 6},
             {3, 0, 4},
             {3, 4, 7}}};
}

TriangleMesh torus(const TorusSize& size)
{
    constexpr double turn = 2 * std::numbers::pi;
    TriangleMesh mesh;
    for (Slot i = 0; i < size.around; ++i) {
        for (Slot j = 0; j < size.across; ++j) {
            const double a = turn * i / size.around, b = turn * j / size.across;
            const double r = size.ring + size.tube * std::cos(b);
            mesh.points.push_back(core::Vec3(r * std::cos(a), size.tube * std::sin(b), -r * std::sin(a)).cast<float>());
            const auto vertex = [&](Slot u, Slot v) { return u % size.around * size.across + v % size.across; };
            const Slot p = vertex(i, j), q = vertex(i + 1, j), r2 = vertex(i + 1, j + 1), s = vertex(i, j + 1);
            mesh.triangles.push_back({p, q, r2});
            mesh.triangles.push_back({p, r2, s});
        }
    }
    return mesh;
}

TriangleMesh nestedSpheres(bool innerFacesInwards)
{
    const TriangleMesh inner = core::icosphere(1, 1);
    return together(core::icosphere(2, 3), innerFacesInwards ? reversed(inner) : inner);
}

TriangleMesh openCone(Slot corners)
{
    TriangleMesh mesh{{{0, 1, 0}}, {}, {}};
    for (Slot i = 0; i < corners; ++i) {
        const double a = 2 * std::numbers::pi * i / corners;
        mesh.points.push_back(core::Vec3(std::cos(a), 0, -std::sin(a)).cast<float>());
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % corners});
    }
    return mesh;
}

TriangleMesh bowTie()
{
    const TriangleMesh one = moved(tetrahedron(), {-1, -1, -1}); // has vertex 0 at the origin
    TriangleMesh mesh = one;
    const Slot shift = static_cast<Slot>(one.points.size()) - 1;
    for (std::size_t i = 1; i < one.points.size(); ++i)
        mesh.points.push_back(-one.points[i]);
    const auto other = [shift](Slot corner) { return corner == 0 ? 0 : corner + shift; };
    for (const auto& [a, b, c] : one.triangles)
        mesh.triangles.push_back({other(a), other(c), other(b)}); // point reflection reverses the orientation of faces
    return mesh;
}

TriangleMesh threeFacesAtEdge()
{
    return {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}}, {}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
}

TriangleMesh cubeWithFlippedFace()
{
    TriangleMesh mesh = cube(2);
    std::swap(mesh.triangles[4][1], mesh.triangles[4][2]);
    return mesh;
}

TriangleMesh pushedThroughTetrahedron()
{
    TriangleMesh mesh = tetrahedron();
    mesh.points[0] = {-1, -1, -1}; // on the far side of the plane through the other three points
    return mesh;
}

TriangleMesh touchingCubes()
{
    // The second cube is rotated to have its corner on the top face of the first cube.
    TriangleMesh second = cube(2);
    for (Vec3f& p : second.points) {
        const float x = p.x(), y = p.y(), z = p.z();
        p = {x - y, x + y + z + 4, z - y}; // maps the corner (-1,-1,-1) to (0, 1, 0)
    }
    return together(cube(2), second);
}

TriangleMesh sphereThroughSphere()
{
    return together(core::icosphere(2, 1), moved(core::icosphere(2, 1), {0.7f, 0.1f, 0.2f}));
}

TriangleMesh moved(TriangleMesh mesh, const Vec3f& by)
{
    for (Vec3f& p : mesh.points)
        p += by;
    return mesh;
}

TriangleMesh takenApart(const TriangleMesh& mesh, float distance)
{
    constexpr float size = 0.9f;
    TriangleMesh apart;
    for (const auto& t : mesh.triangles) {
        const Vec3f &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        const Vec3f middle = (a + b + c) / 3, normal = (b - a).cross(c - a).normalized();
        const auto first = static_cast<Slot>(apart.points.size());
        for (const Slot v : t)
            apart.points.push_back(middle + size * (mesh.points[v] - middle) + distance * normal);
        apart.triangles.push_back({first, first + 1, first + 2});
    }
    return apart;
}

TriangleMesh scaled(TriangleMesh mesh, float by)
{
    for (Vec3f& p : mesh.points)
        p *= by;
    return mesh;
}

TriangleMesh reversed(TriangleMesh mesh)
{
    for (core::Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

TriangleMesh together(TriangleMesh a, const TriangleMesh& b)
{
    const auto shift = static_cast<Slot>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const auto& [p, q, r] : b.triangles)
        a.triangles.push_back({p + shift, q + shift, r + shift});
    return a;
}

TriangleMesh noisy(TriangleMesh mesh, float amount, unsigned seed)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> offset(-amount, amount);
    for (Vec3f& p : mesh.points)
        for (int i = 0; i < 3; ++i)
            p[i] += offset(engine);
    return mesh;
}

TriangleMesh shuffled(const TriangleMesh& mesh, StrokeFuzzer& random)
{
    std::vector<Slot> order(mesh.points.size());
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random.below(i)]);
    TriangleMesh result;
    result.points.resize(order.size());
    result.colors.resize(mesh.colors.size());
    for (std::size_t v = 0; v < order.size(); ++v) {
        result.points[order[v]] = mesh.points[v];
        if (!mesh.colors.empty())
            result.colors[order[v]] = mesh.colors[v];
    }
    for (core::Triangle t : mesh.triangles) {
        for (Slot& v : t)
            v = order[v];
        std::ranges::rotate(t, t.begin() + static_cast<std::ptrdiff_t>(random.below(3)));
        result.triangles.push_back(t);
    }
    for (std::size_t i = result.triangles.size(); i > 1; --i)
        std::swap(result.triangles[i - 1], result.triangles[random.below(i)]);
    return result;
}
} // namespace shapes
