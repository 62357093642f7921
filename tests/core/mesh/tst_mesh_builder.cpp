#include "core/mesh/mesh_builder.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>

using core::buildMesh;
using core::BuildResult;
using core::extractMesh;
using core::Slot;
using core::TriangleMesh;
using core::Vec3;
using core::Vec3f;

namespace
{
TriangleMesh coloured(TriangleMesh mesh)
{
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
        mesh.colors.push_back({static_cast<std::uint8_t>(v), static_cast<std::uint8_t>(v / 256), 3});
    return mesh;
}
} // namespace

class TestMeshBuilder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void soundModels_areBuilt_data();
    void soundModels_areBuilt();
    void fileOrder_doesNotMatter();
    void neighboursInSpace_areNeighboursInMemory();
    void farModel_isMovedToTheOrigin();
    void nearModel_staysWhereItIs();
    void centre_movesTheBoxesMiddleToTheOrigin();
    void points_areSnappedToTheNearestLatticePoint();
    void pointsOnTheLattice_areKeptBitForBit();
    void unusedVertices_areLeftOut();
    void brokenModels_areRefused_data();
    void brokenModels_areRefused();
    void extractMesh_roundTrips();
};

void TestMeshBuilder::soundModels_areBuilt_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::newRow("tetrahedron") << shapes::tetrahedron();
    QTest::newRow("cube") << shapes::cube(20);
    QTest::newRow("sphere") << core::icosphere(3, 50);
    QTest::newRow("noisySphere") << shapes::noisy(core::icosphere(3, 50), 0.3f, 5);
    QTest::newRow("nestedShells") << shapes::nestedSpheres(true);
    QTest::newRow("thinSlab") << clay::slab(2, 0.001, 8);
    QTest::newRow("bowl") << clay::bowl();
    QTest::newRow("tiny") << core::icosphere(2, 1e-6);
    QTest::newRow("huge") << core::icosphere(2, 1e6);
}

void TestMeshBuilder::soundModels_areBuilt()
{
    QFETCH(TriangleMesh, shape);
    const BuildResult result = buildMesh(shape);
    QVERIFY(result.mesh && result.report.printReady());
    QCOMPARE(result.unsnappable, std::size_t(0));
    VERIFY_VALID(*result.mesh);
    QCOMPARE(std::size_t(result.mesh->live().vertices), shape.points.size());
    QCOMPARE(std::size_t(result.mesh->live().faces), shape.triangles.size());
    QVERIFY(result.mesh->frame().place == Vec3::Zero());
}

void TestMeshBuilder::fileOrder_doesNotMatter()
{
    StrokeFuzzer random(20240812);
    for (const TriangleMesh& shape : {coloured(core::icosphere(3, 50)), clay::bowl(), shapes::nestedSpheres(true)}) {
        const std::uint64_t state = buildMesh(shape).mesh->stateHash();
        for (int i = 0; i < 5; ++i)
            QCOMPARE(buildMesh(shapes::shuffled(shape, random)).mesh->stateHash(), state);
    }
}

void TestMeshBuilder::neighboursInSpace_areNeighboursInMemory()
{
    StrokeFuzzer random(20240812);
    const auto mesh = buildMesh(shapes::shuffled(core::icosphere(5, 50), random)).mesh;
    double sum = 0;
    for (Slot e = 0; e < mesh->slots().edges; ++e)
        sum += std::abs(double(mesh->to(2 * e)) - double(mesh->to(2 * e + 1)));
    const double mean = sum / mesh->slots().edges;
    // in random order the mean would be a third of the vertices
    QVERIFY2(mean < mesh->slots().vertices / 20.0, qPrintable(QString::number(mean)));
}

void TestMeshBuilder::farModel_isMovedToTheOrigin()
{
    const TriangleMesh far = shapes::moved(core::icosphere(3, 1), {1000, -3000, 500});
    const BuildResult result = buildMesh(far);
    QVERIFY(result.mesh);
    QVERIFY((result.mesh->frame().place - Vec3(1000, -3000, 500)).norm() < 0.01);
    core::Box box;
    for (Slot v = 0; v < result.mesh->slots().vertices; ++v)
        box.extend(result.mesh->point(v).cast<double>());
    QVERIFY(box.center().norm() < 0.01);
    VERIFY_VALID(*result.mesh);
}

void TestMeshBuilder::nearModel_staysWhereItIs()
{
    const BuildResult result = buildMesh(shapes::moved(core::icosphere(3, 1), {3, -3, 2}));
    QVERIFY(result.mesh && result.mesh->frame().place == Vec3::Zero());
}

void TestMeshBuilder::centre_movesTheBoxesMiddleToTheOrigin()
{
    const BuildResult result = buildMesh(shapes::moved(core::icosphere(3, 1), {3, -3, 2}), true);
    QVERIFY(result.mesh && (result.mesh->frame().place - Vec3(3, -3, 2)).norm() < 1e-3);
}

void TestMeshBuilder::points_areSnappedToTheNearestLatticePoint()
{
    const TriangleMesh shape = shapes::noisy(core::icosphere(3, 50), 0.2f, 3);
    const BuildResult result = buildMesh(shape);
    QVERIFY(result.mesh);
    QCOMPARE(result.resnapped, std::size_t(0));
    std::vector<std::array<float, 3>> expected, built;
    for (const Vec3f& p : shape.points) {
        const Vec3f snapped = result.mesh->lattice().snap(p.cast<double>());
        expected.push_back({snapped.x(), snapped.y(), snapped.z()});
    }
    for (Slot v = 0; v < result.mesh->slots().vertices; ++v)
        built.push_back({result.mesh->point(v).x(), result.mesh->point(v).y(), result.mesh->point(v).z()});
    std::ranges::sort(expected);
    std::ranges::sort(built);
    QVERIFY(expected == built);
}

void TestMeshBuilder::pointsOnTheLattice_areKeptBitForBit()
{
    const TriangleMesh once = extractMesh(*buildMesh(shapes::noisy(core::icosphere(3, 50), 0.2f, 3)).mesh);
    const TriangleMesh twice = extractMesh(*buildMesh(once).mesh);
    QVERIFY(once.points == twice.points && once.triangles == twice.triangles);
}

void TestMeshBuilder::unusedVertices_areLeftOut()
{
    TriangleMesh shape = shapes::cube(2);
    shape.points.insert(shape.points.begin(), Vec3f(900, 0, 0));
    for (core::Triangle& t : shape.triangles) {
        for (Slot& v : t)
            ++v;
    }
    const BuildResult result = buildMesh(shape), plain = buildMesh(shapes::cube(2));
    QVERIFY(result.mesh && plain.mesh);
    QCOMPARE(result.mesh->stateHash(), plain.mesh->stateHash());
}

void TestMeshBuilder::brokenModels_areRefused_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::newRow("open") << shapes::openCone(6);
    QTest::newRow("bowTie") << shapes::bowTie();
    QTest::newRow("threeFacesAtEdge") << shapes::threeFacesAtEdge();
    QTest::newRow("flippedFace") << shapes::cubeWithFlippedFace();
    QTest::newRow("insideOut") << shapes::reversed(shapes::cube(2));
    QTest::newRow("innerShellFacesOutwards") << shapes::nestedSpheres(false);
    QTest::newRow("touching") << shapes::touchingCubes();
    QTest::newRow("throughEachOther") << shapes::sphereThroughSphere();
    TriangleMesh degenerate = shapes::cube(2);
    degenerate.points[0] = degenerate.points[1];
    QTest::newRow("degenerate") << degenerate;
}

void TestMeshBuilder::brokenModels_areRefused()
{
    QFETCH(TriangleMesh, shape);
    const BuildResult result = buildMesh(shape);
    QVERIFY(!result.mesh && !result.report.printReady());
}

void TestMeshBuilder::extractMesh_roundTrips()
{
    for (const TriangleMesh& shape : {coloured(core::icosphere(2, 50)), clay::bowl()}) {
        const auto mesh = buildMesh(shape).mesh;
        mesh->beginStroke(); // collapses leave holes in the slots
        for (Slot h = 0; h < 40; ++h) {
            if (mesh->isEdge(h / 2) && mesh->isCollapseOk(h))
                mesh->collapse(h, mesh->point(mesh->to(h)));
        }
        mesh->endStroke();
        QVERIFY(mesh->live().vertices < mesh->slots().vertices);
        const TriangleMesh out = extractMesh(*mesh);
        QCOMPARE(out.points.size(), std::size_t(mesh->live().vertices));
        QCOMPARE(out.triangles.size(), std::size_t(mesh->live().faces));
        QCOMPARE(out.colors.size(), shape.colors.empty() ? std::size_t(0) : out.points.size());
        QCOMPARE(core::Mesh(out, mesh->lattice()).meshHash(), mesh->meshHash());
    }
}

FETTLE_TEST(TestMeshBuilder)
#include "tst_mesh_builder.moc"
