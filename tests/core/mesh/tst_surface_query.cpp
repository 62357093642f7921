#include "core/geometry/point_triangle.h"
#include "core/mesh/surface_query.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

using core::FaceOctree;
using core::Mesh;
using core::Ray;
using core::Slot;
using core::SurfaceHit;
using core::TriangleMesh;
using core::Vec3;
using mesh_asserts::sculptable;

namespace
{
std::array<Vec3, 3> cornersOf(const Mesh& mesh, Slot f)
{
    const core::Triangle& t = mesh.corners(f);
    return {mesh.point(t[0]).cast<double>(), mesh.point(t[1]).cast<double>(), mesh.point(t[2]).cast<double>()};
}

/// Returns the distance to the first hit, found by signed volumes and independent of the engine's method. `margin` gets
/// the smallest absolute volume; near 0 the ray grazes an edge.
double firstHitByBruteForce(const Mesh& mesh, const Ray& ray, double& margin)
{
    const auto volume = [](const Vec3& a, const Vec3& b, const Vec3& c) { return a.cross(b).dot(c); };
    double first = std::numeric_limits<double>::infinity();
    margin = first;
    for (Slot f = 0; f < mesh.slots().faces; ++f) {
        const auto [a, b, c] = cornersOf(mesh, f);
        const Vec3 d = ray.direction;
        const double u = volume(a - ray.origin, b - ray.origin, d), v = volume(b - ray.origin, c - ray.origin, d),
                     w = volume(c - ray.origin, a - ray.origin, d);
        margin = std::min({margin, std::abs(u), std::abs(v), std::abs(w)});
        const Vec3 n = (b - a).cross(c - a);
        if (u > 0 || v > 0 || w > 0 || n.dot(d) >= 0)
            continue; // a ray that enters from outside has the three corners clockwise around it
        const double t = n.dot(a - ray.origin) / n.dot(d);
        if (t >= 0)
            first = std::min(first, t);
    }
    return first;
}
} // namespace

class TestSurfaceQuery : public QObject
{
    Q_OBJECT

    static constexpr std::uint64_t seed = 20240812;

private Q_SLOTS:
    void firstHit_agreesWithBruteForce_data();
    void firstHit_agreesWithBruteForce();
    void nearestPoint_agreesWithBruteForce_data() { firstHit_agreesWithBruteForce_data(); }
    void nearestPoint_agreesWithBruteForce();
    void nearestInTriangle_isNotFartherThanAnyPointOfIt();
    void ray_fromInsideMissesAndFromOutsideHits();
    void farAway_hasAnAnswer();
    void color_isTheCornersAndBetweenThemTheirMean();
};

void TestSurfaceQuery::firstHit_agreesWithBruteForce_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::newRow("sphere") << core::icosphere(2, 1);
    QTest::newRow("torus") << shapes::torus();
    QTest::newRow("bowl") << clay::bowl();
    QTest::newRow("nestedShells") << shapes::nestedSpheres(true);
    QTest::newRow("thinSlab") << clay::slab(2, 0.01, 6);
}

void TestSurfaceQuery::firstHit_agreesWithBruteForce()
{
    QFETCH(TriangleMesh, shape);
    const auto mesh = sculptable(shape);
    const FaceOctree octree(*mesh);
    StrokeFuzzer random(seed);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Ray ray = {random.uniform(0, 5) * random.direction(), random.uniform(0.1, 3) * random.direction()};
        double margin = 0;
        const double expected = firstHitByBruteForce(*mesh, ray, margin);
        if (margin < 1e-9)
            continue; // the ray grazes an edge, where the result is ambiguous
        const std::optional<SurfaceHit> hit = firstHit(*mesh, octree, ray);
        QCOMPARE(hit.has_value(), std::isfinite(expected));
        if (!hit)
            continue;
        ++hits;
        QVERIFY((hit->position - (ray.origin + expected * ray.direction)).norm() < 1e-9);
        QVERIFY(std::abs(hit->distance - expected * ray.direction.norm()) < 1e-9);
        const auto [a, b, c] = cornersOf(*mesh, hit->face);
        QVERIFY(std::abs(hit->normal.norm() - 1) < 1e-12 && std::abs(hit->normal.dot(hit->position - a)) < 1e-9);
        QVERIFY(hit->normal.dot((b - a).cross(c - a)) > 0 && hit->normal.dot(ray.direction) < 0);
    }
    QVERIFY(hits > 100);
}

void TestSurfaceQuery::nearestPoint_agreesWithBruteForce()
{
    QFETCH(TriangleMesh, shape);
    const auto mesh = sculptable(shape);
    const FaceOctree octree(*mesh);
    StrokeFuzzer random(seed);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 point = random.uniform(0, 6) * random.direction();
        double expected = std::numeric_limits<double>::infinity();
        for (Slot f = 0; f < mesh->slots().faces; ++f)
            expected = std::min(expected, (core::nearestInTriangle(point, cornersOf(*mesh, f)) - point).norm());
        const std::optional<SurfaceHit> hit = nearestPoint(*mesh, octree, point);
        QVERIFY(hit);
        QVERIFY(std::abs(hit->distance - expected) < 1e-12);
        QVERIFY(std::abs((hit->position - point).norm() - expected) < 1e-12);
        QVERIFY((core::nearestInTriangle(hit->position, cornersOf(*mesh, hit->face)) - hit->position).norm() < 1e-9);
    }
}

void TestSurfaceQuery::nearestInTriangle_isNotFartherThanAnyPointOfIt()
{
    StrokeFuzzer random(seed);
    for (int i = 0; i < 3000; ++i) {
        const std::array<Vec3, 3> t = {random.direction(), random.direction(), random.direction()};
        const Vec3 p = random.uniform(0, 3) * random.direction();
        const double distance = (core::nearestInTriangle(p, t) - p).norm();
        for (int k = 0; k < 50; ++k) {
            double u = random.uniform(), v = random.uniform();
            if (u + v > 1)
                u = 1 - u, v = 1 - v;
            QVERIFY(distance <= (t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]) - p).norm() + 1e-12);
        }
    }
}

void TestSurfaceQuery::ray_fromInsideMissesAndFromOutsideHits()
{
    const auto mesh = sculptable(core::icosphere(3, 1));
    const FaceOctree octree(*mesh);
    QVERIFY(!firstHit(*mesh, octree, {{0, 0, 0}, {0.1, 0.2, 1}})); // back faces are not hit
    const auto hit = firstHit(*mesh, octree, {{0.1, 0.05, 100}, {0, 0, -1}});
    QVERIFY(hit && std::abs(hit->position.norm() - 1) < 0.01);
    QVERIFY(!firstHit(*mesh, octree, {{0.1, 0.05, 100}, {0, 0, 1}}));
}

void TestSurfaceQuery::farAway_hasAnAnswer()
{
    const auto mesh = sculptable(core::icosphere(3, 1));
    const FaceOctree octree(*mesh);
    const Vec3 far(1e7, 2e6, -3e6); // 10 km away if the unit is mm
    const auto nearest = nearestPoint(*mesh, octree, far);
    QVERIFY(nearest && std::abs(nearest->position.norm() - 1) < 0.05);
    QVERIFY(firstHit(*mesh, octree, {far, -far}));
    QVERIFY(!firstHit(*mesh, octree, {far, far}));
}

void TestSurfaceQuery::color_isTheCornersAndBetweenThemTheirMean()
{
    const auto mesh = sculptable(core::icosphere(1, 1));
    mesh->beginStroke();
    const core::Triangle t = mesh->corners(0);
    const core::Rgb colors[] = {{250, 0, 10}, {10, 250, 0}, {0, 10, 250}};
    for (std::size_t i = 0; i < 3; ++i)
        mesh->setColor(t[i], colors[i]);
    const FaceOctree octree(*mesh);
    const auto [a, b, c] = cornersOf(*mesh, 0);
    const auto at = [&](double u, double v) {
        return nearestPoint(*mesh, octree, (1 - u - v) * a + u * b + v * c)->color;
    };
    QCOMPARE(at(1.0 / 3, 1.0 / 3), (core::Rgb{87, 87, 87}));
    QCOMPARE(at(0.5, 0.25), (core::Rgb{68, 128, 65}));
    QCOMPARE(at(0.998, 0.001), colors[1]);
}

FETTLE_TEST(TestSurfaceQuery)
#include "tst_surface_query.moc"
