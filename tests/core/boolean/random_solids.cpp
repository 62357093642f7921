#include "tests/core/boolean/random_solids.h"

#include "core/analysis/mesh_check.h"
#include "tests/support/shapes.h"
#include "tests/support/sharp_shapes.h"
#include "tests/support/stroke_fuzzer.h"

#include <functional>
#include <iterator>

using namespace core;

namespace
{
TriangleMesh turned(TriangleMesh mesh, const Eigen::Quaterniond& turn)
{
    for (Vec3f& p : mesh.points)
        p = (turn * p.cast<double>()).cast<float>();
    return mesh;
}

Eigen::Quaterniond anyTurn(StrokeFuzzer& random)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(0, 6.28), random.direction()));
}

Vec3f anyVector(StrokeFuzzer& random, double most)
{
    return (random.uniform(0, most) * random.direction()).cast<float>();
}

Vec3f gridPoint(StrokeFuzzer& random, std::uint64_t side)
{
    return {static_cast<float>(random.below(side)), static_cast<float>(random.below(side)),
            static_cast<float>(random.below(side))};
}

/// Returns a shape about two units large around the origin.
TriangleMesh anyShape(StrokeFuzzer& random)
{
    switch (random.below(5)) {
    case 0:
        return shapes::moved(shapes::cube(1.5F), {-0.75F, -0.75F, -0.75F});
    case 1:
        return shapes::scaled(shapes::torus(), 0.3F);
    case 2:
        return icosphere(static_cast<int>(random.below(4)), 1);
    case 3:
        return gridBox({1, random.uniform(0.1, 1), random.uniform(0.1, 1)}, 1 + static_cast<int>(random.below(6)));
    default:
        return shapes::scaled(shapes::tetrahedron(), 1.5F);
    }
}

/// Returns a block with integer coordinates, at least one unit wide.
TriangleMesh gridBlock(StrokeFuzzer& random)
{
    const Vec3f low = gridPoint(random, 4), size = gridPoint(random, 3) + Vec3f::Ones();
    TriangleMesh block = gridBox(size.cast<double>() / 2, 1 + static_cast<int>(random.below(3)));
    return shapes::moved(std::move(block), low + size / 2);
}

TriangleMesh gridTetrahedron(StrokeFuzzer& random)
{
    TriangleMesh mesh{{}, {}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    for (int i = 0; i < 4; ++i)
        mesh.points.push_back(gridPoint(random, 5));
    const Vec3f &a = mesh.points[0], u = mesh.points[1] - a, v = mesh.points[2] - a, w = mesh.points[3] - a;
    return u.cross(v).dot(w) < 0 ? shapes::reversed(mesh) : mesh;
}

TriangleMesh rough(StrokeFuzzer& random)
{
    return shapes::noisy(icosphere(3, 1), 0.03F, static_cast<unsigned>(random.below(1'000'000)));
}

TriangleMesh needle(StrokeFuzzer& random)
{
    TriangleMesh mesh = anyShape(random);
    const float thin = static_cast<float>(std::pow(10, random.uniform(-4, -1)));
    for (Vec3f& p : mesh.points)
        p = p.cwiseProduct(Vec3f(3, thin, random.below(2) == 0 ? thin : 1));
    return turned(std::move(mesh), anyTurn(random));
}

TriangleMesh prism(StrokeFuzzer& random, double from, double to)
{
    return ::turned({{0, from}, {1, from}, {1, to}, {0, to}}, 3 + static_cast<int>(random.below(20)));
}

/// Moves or turns a mesh by 1e-8 to 1e-3, which rounding may hide.
TriangleMesh nudged(const TriangleMesh& mesh, StrokeFuzzer& random)
{
    const double little = std::pow(10, random.uniform(-8, -3));
    if (random.below(2) == 0)
        return shapes::moved(mesh, anyVector(random, little));
    return turned(mesh, Eigen::Quaterniond(Eigen::AngleAxisd(little, random.direction())));
}

SolidPair rotated(StrokeFuzzer& random)
{
    return {"rotated", turned(anyShape(random), anyTurn(random)),
            shapes::moved(turned(anyShape(random), anyTurn(random)), anyVector(random, 1.5))};
}

SolidPair blocks(StrokeFuzzer& random)
{
    return {"blocks on a grid", gridBlock(random), gridBlock(random), true};
}

SolidPair tetrahedra(StrokeFuzzer& random)
{
    return {"tetrahedra on a grid", gridTetrahedron(random), gridTetrahedron(random), true};
}

SolidPair tetrahedronAndBlock(StrokeFuzzer& random)
{
    return {"tetrahedron and block on a grid", gridTetrahedron(random), gridBlock(random), true};
}

SolidPair prisms(StrokeFuzzer& random)
{
    const TriangleMesh first = prism(random, -1, 1);
    return {"prisms of one axis", first, shapes::moved(first, {0, static_cast<float>(random.uniform(-2, 2)), 0}), true};
}

SolidPair nested(StrokeFuzzer& random)
{
    const TriangleMesh outer = random.below(2) == 0 ? icosphere(3, 3) : shapes::nestedSpheres(true);
    const float scale = static_cast<float>(random.uniform(0.1, 0.5));
    return {"nested", outer, shapes::scaled(turned(anyShape(random), anyTurn(random)), scale)};
}

SolidPair identical(StrokeFuzzer& random)
{
    const TriangleMesh mesh = turned(anyShape(random), anyTurn(random));
    return {"identical", mesh, shapes::shuffled(mesh, random), true};
}

SolidPair nearlyIdentical(StrokeFuzzer& random)
{
    const TriangleMesh mesh = turned(anyShape(random), anyTurn(random));
    return {"nearly identical", mesh, nudged(mesh, random), true};
}

SolidPair touching(StrokeFuzzer& random)
{
    const TriangleMesh first = turned(anyShape(random), anyTurn(random));
    TriangleMesh second = turned(anyShape(random), anyTurn(random));
    const Triangle& face = first.triangles[random.below(first.triangles.size())];
    const Vec3f corner = first.points[face[0]], edge = (corner + first.points[face[1]]) / 2;
    const Vec3f middle = (corner + first.points[face[1]] + first.points[face[2]]) / 3;
    const Vec3f place = std::array{corner, edge, middle}[random.below(3)];
    const Vec3f tip = second.points[second.triangles[random.below(second.triangles.size())][0]];
    return {"a vertex on the surface", first, shapes::moved(std::move(second), place - tip), true};
}

SolidPair needles(StrokeFuzzer& random)
{
    const TriangleMesh other = random.below(2) == 0 ? needle(random) : turned(anyShape(random), anyTurn(random));
    return {"needles", needle(random), shapes::moved(other, anyVector(random, 0.5))};
}

SolidPair roughBalls(StrokeFuzzer& random)
{
    return {"rough", rough(random), shapes::moved(rough(random), anyVector(random, 1.5))};
}

SolidPair farAway(StrokeFuzzer& random)
{
    SolidPair pair = random.below(2) == 0 ? rotated(random) : blocks(random);
    const Vec3f away = anyVector(random, 1000);
    return {"far away", shapes::moved(pair.a, away), shapes::moved(pair.b, away), true};
}

const std::function<SolidPair(StrokeFuzzer&)> kinds[] = {rotated,  blocks,  tetrahedra, tetrahedronAndBlock,
                                                         prisms,   nested,  identical,  nearlyIdentical,
                                                         touching, needles, roughBalls, farAway};
} // namespace

SolidPair randomPair(unsigned seed)
{
    for (std::uint64_t attempt = 0;; ++attempt) {
        StrokeFuzzer random(seed + (attempt << 32));
        SolidPair pair = kinds[seed % std::size(kinds)](random);
        if (checkMesh(pair.a).printReady() && checkMesh(pair.b).printReady())
            return pair;
    }
}
