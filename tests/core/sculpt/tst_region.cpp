#include "core/mesh/surface_query.h"
#include "core/sculpt/select/region.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <limits>

using core::FaceOctree;
using core::Region;
using core::Slot;
using core::Sphere;
using core::Vec3;
using mesh_asserts::sculptable;

class TestRegion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void selectSphere_takesTheVerticesInTheBall();
    void nearestPoint_isWithinReach();
    void selectGeodesic_takesTheNearSheetOnly();
    void selectGeodesic_isTheShortestPathAlongEdges();
    void candidates_holdAllFacesThatMayMeetTheBall();
    void addAndRemove_keepPositions();
    void restore_goesBack();
    void latticeBox_holdsTheBallAndIsClipped();
};

void TestRegion::selectSphere_takesTheVerticesInTheBall()
{
    const auto mesh = sculptable(shapes::torus());
    const FaceOctree octree(*mesh);
    StrokeFuzzer random(20240812);
    Region region;
    std::vector<Slot> candidates;
    for (int i = 0; i < 500; ++i) {
        const Sphere ball = {random.uniform(0, 5) * random.direction(), random.uniform(0.01, 3)};
        selectSphere(region, candidates, *mesh, octree, ball);
        std::vector<Slot> expected;
        for (Slot v = 0; v < mesh->slots().vertices; ++v) {
            if ((mesh->point(v).cast<double>() - ball.center).squaredNorm() <= ball.radius * ball.radius)
                expected.push_back(v);
        }
        QCOMPARE(region.slots(), expected); // slots are in ascending order
        QCOMPARE(region.size(), static_cast<Slot>(expected.size()));
    }
}

/// Tests points at any distance from the surface, and limits within which there is no surface.
void TestRegion::nearestPoint_isWithinReach()
{
    const auto mesh = sculptable(clay::slab(1, 0.05, 40));
    const FaceOctree octree(*mesh);
    const double height = nearestPoint(*mesh, octree, {0, 1, 0})->distance;
    for (const double within : {0.0, 0.1 * height, 0.999 * height})
        QVERIFY(!nearestPoint(*mesh, octree, {0, 1, 0}, within));
    for (const double within : {1.001 * height, 5.0, 1e9})
        QCOMPARE(nearestPoint(*mesh, octree, {0, 1, 0}, within)->distance, height);
    QVERIFY(nearestPoint(*mesh, octree, {1e6, 1e6, 1e6}));
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!nearestPoint(*mesh, octree, {nan, 0, 0}));
}

/// Figure 4 of the paper: beside a fold the ray brush selects only the near side, the spherical brush both sides.
void TestRegion::selectGeodesic_takesTheNearSheetOnly()
{
    const auto mesh = sculptable(clay::slab(1, 0.05, 40));
    const FaceOctree octree(*mesh);
    const auto top = nearestPoint(*mesh, octree, {0, 1, 0});
    QVERIFY(top);
    const Sphere ball = {top->position, 0.2};
    Region region;
    std::vector<Slot> candidates;
    const auto below = [&] {
        return std::ranges::count_if(region.slots(), [&](Slot v) { return mesh->point(v).y() < 0; });
    };
    selectSphere(region, candidates, *mesh, octree, ball);
    QVERIFY(below() > 0);
    candidates = {top->face};
    selectGeodesic(region, candidates, *mesh, ball);
    QVERIFY(region.size() > 100);
    QCOMPARE(below(), 0);
}

void TestRegion::selectGeodesic_isTheShortestPathAlongEdges()
{
    const auto mesh = sculptable(shapes::torus());
    const FaceOctree octree(*mesh);
    StrokeFuzzer random(20241205);
    Region region;
    for (int i = 0; i < 50; ++i) {
        const auto start = nearestPoint(*mesh, octree, 4 * random.direction());
        const Sphere ball = {start->position, random.uniform(0.1, 3)};
        std::vector<Slot> candidates = {start->face};
        selectGeodesic(region, candidates, *mesh, ball);
        // Bellman-Ford condition: no edge shortens a path, and every vertex within reach is selected.
        for (Slot v = 0; v < mesh->slots().vertices; ++v) {
            const Vec3 p = mesh->point(v).cast<double>();
            double best = std::ranges::count(mesh->corners(start->face), v) ? (p - ball.center).norm() : 1e9;
            mesh->forEachOutgoing(v, [&](Slot h) {
                const Slot other = mesh->to(h);
                if (region.contains(other))
                    best = std::min(best, region.distance(other) + (mesh->point(other).cast<double>() - p).norm());
            });
            QCOMPARE(region.contains(v), best <= ball.radius);
            QVERIFY(!region.contains(v) || std::abs(region.distance(v) - best) < 1e-9);
        }
    }
}

void TestRegion::candidates_holdAllFacesThatMayMeetTheBall()
{
    const auto mesh = sculptable(shapes::torus());
    const FaceOctree octree(*mesh);
    Region region;
    std::vector<Slot> candidates;
    const Sphere ball = {{3, 1, 0}, 0.7};
    selectSphere(region, candidates, *mesh, octree, ball);
    for (Slot f = 0; f < mesh->slots().faces; ++f) {
        const bool meets = boxOf(*mesh, f).meets(latticeBox(mesh->lattice(), ball));
        QVERIFY(!meets || std::ranges::count(candidates, f) == 1);
    }
}

void TestRegion::addAndRemove_keepPositions()
{
    Region region;
    QVERIFY(region.empty());
    region.add(9, 0, {1, 0, 0});
    region.add(4, 0, {2, 0, 0});
    QCOMPARE(region.size(), 2u);
    region.remove(9);
    QVERIFY(!region.contains(9) && region.contains(4));
    QCOMPARE(region.size(), 1u);
    region.add(9, 0, {3, 0, 0}); // the slot was reused by another vertex
    QCOMPARE(region.size(), 2u);
    QVERIFY(region.plan(9) == Vec3(3, 0, 0) && region.plan(4) == Vec3(2, 0, 0));
    QCOMPARE(region.position(9), 0u);
    std::vector<Slot> visited;
    region.forEach([&](Slot v) {
        visited.push_back(v);
        if (v == 4)
            region.setPlan(v, {5, 0, 0});
    });
    QCOMPARE(visited, (std::vector<Slot>{9, 4}));
    QVERIFY(region.plan(4) == Vec3(5, 0, 0));
    region.clear();
    QVERIFY(region.empty() && !region.contains(9));
}

void TestRegion::restore_goesBack()
{
    Region region;
    for (Slot v = 0; v < 20; ++v)
        region.add(3 * v, 0, {double(v), 0, 0});
    region.remove(6);
    const Region::Saved saved = region.save();
    region.remove(9);
    region.add(6, 0, {77, 0, 0});
    region.add(100, 0, {1, 1, 1});
    region.setPlan(0, {8, 8, 8});
    region.restore(saved);
    QCOMPARE(region.size(), 19u);
    QVERIFY(!region.contains(100) && !region.contains(6) && region.contains(9));
    QVERIFY(region.plan(0) == Vec3::Zero() && region.plan(9) == Vec3(3, 0, 0));

    // After refinement the ray brush selects again, possibly with another order of slots.
    region.clear();
    for (Slot v = 200; v > 100; --v)
        region.add(v, 1);
    region.restore(saved);
    QCOMPARE(region.size(), 19u);
    QVERIFY(!region.contains(150) && region.contains(9) && region.plan(9) == Vec3(3, 0, 0));
}

void TestRegion::latticeBox_holdsTheBallAndIsClipped()
{
    const core::Lattice lattice(10);
    const core::LatticeBox box = latticeBox(lattice, {{1, 2, 3}, 0.5});
    QVERIFY(box.min == core::LatticePoint(512, 1536, 2560) && box.max == core::LatticePoint(1536, 2560, 3584));
    const core::LatticeBox all = latticeBox(lattice, {{0, 0, 0}, 1e30});
    QVERIFY(all.min == core::LatticePoint::Constant(-core::Lattice::limit));
    QVERIFY(all.max == core::LatticePoint::Constant(core::Lattice::limit));
}

FETTLE_TEST(TestRegion)
#include "tst_region.moc"
