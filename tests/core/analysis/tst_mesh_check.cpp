// Tests the check of whole models: named shapes by their known properties, random models against CGAL.

#include "core/analysis/mesh_check.h"
#include "core/analysis/nesting.h"
#include "core/geometry/lattice_placement.h"
#include "core/geometry/triangle_intersection.h"
#include "tests/support/cgal_judge.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace
{
using core::FloatPredicates;
using core::LatticePoint;
using core::LatticePredicates;
using core::MeshReport;
using core::Slot;
using core::TriangleMesh;
using core::Vec3f;

constexpr unsigned seed = 20240812;

/// Returns the same surface with vertices and faces in random order and with a random first corner in each face.
TriangleMesh shuffled(const TriangleMesh& mesh, unsigned by)
{
    std::mt19937 engine(by);
    std::vector<Slot> place(mesh.points.size());
    for (Slot i = 0; i < place.size(); ++i)
        place[i] = i;
    std::shuffle(place.begin(), place.end(), engine);
    TriangleMesh result = mesh;
    for (std::size_t i = 0; i < place.size(); ++i)
        result.points[place[i]] = mesh.points[i];
    for (core::Triangle& t : result.triangles) {
        t = {place[t[0]], place[t[1]], place[t[2]]};
        std::rotate(t.begin(), t.begin() + engine() % 3, t.end());
    }
    std::shuffle(result.triangles.begin(), result.triangles.end(), engine);
    return result;
}

/// Returns balls at random places. Some are inside out, and some intersect others.
TriangleMesh randomBalls(unsigned by)
{
    std::mt19937 engine(by);
    std::uniform_real_distribution<float> place(-4, 4);
    std::uniform_real_distribution<float> radius(0.2f, 5);
    TriangleMesh all;
    for (auto balls = 2 + engine() % 4; balls != 0; --balls) {
        TriangleMesh ball = shapes::moved(core::icosphere(1, static_cast<double>(radius(engine))),
                                          {place(engine), place(engine), place(engine)});
        all = shapes::together(all, engine() % 2 ? shapes::reversed(ball) : ball);
    }
    return all;
}

/// Makes 1 to 5 nested balls around the origin. Every second one faces inwards; in half of the models one has the wrong
/// orientation.
TriangleMesh nestedBalls(unsigned by)
{
    std::mt19937 engine(by);
    const auto count = 1 + engine() % 5, wrong = engine() % (2 * count);
    TriangleMesh all;
    for (std::size_t i = 0; i < count; ++i) {
        const TriangleMesh ball = core::icosphere(1, static_cast<double>(count - i));
        all = shapes::together(all, (i % 2 == 1) != (i == wrong) ? shapes::reversed(ball) : ball);
    }
    return shuffled(all, by);
}

/// Rounds the coordinates to small integers, so that many vertices, edges and faces touch exactly.
TriangleMesh rounded(TriangleMesh mesh, float scale)
{
    for (Vec3f& p : mesh.points)
        p = (p * scale).array().round();
    return mesh;
}

std::string compareWithCgal(const TriangleMesh& mesh)
{
    const MeshReport report = core::checkMesh(mesh);
    const std::optional<CgalVerdict> verdict = judgedByCgal(mesh);
    if (verdict.has_value() != (report.manifold && report.oriented))
        return "manifold and oriented";
    if (!verdict)
        return {};
    if (verdict->closed != report.closed)
        return "closed";
    if (report.degenerateFaces.count != 0)
        return {}; // CGAL pairs degenerate faces with their neighbours; Fettle only counts them
    if (verdict->intersections != report.intersections.count)
        return std::to_string(report.intersections.count) + " intersections, not " +
               std::to_string(verdict->intersections);
    if (verdict->allWell() != report.printReady())
        return "bounds a solid";
    return {};
}
} // namespace

class TestMeshCheck : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void soundShapes_areReady_data();
    void soundShapes_areReady();
    void brokenShapes_areNamed_data();
    void brokenShapes_areNamed();
    void measures_areThoseOfTheShape();
    void unusedVertices_areLeftOut();
    void noFaces_isNotReady();
    void degenerateFaces_areFound();
    void nesting_isJudgedByDepth();
    void volumeSign_isExact();
    void orderOfElements_doesNotMatter();
    void keptPairs_areTheFirst();
    void equalFaces_areCountedAsOthers();
    void latticeAndFloatAgree();
    void surfaceAndImage_areJudgedAsEachAlone();
    void lattice_tellsWhatImportWouldBreak();
    void placement_movesFarModels();
    void randomShapes_agreeWithCgal_data();
    void randomShapes_agreeWithCgal();
};

void TestMeshCheck::soundShapes_areReady_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<int>("components");
    QTest::addColumn<int>("genus");
    QTest::newRow("tetrahedron") << shapes::tetrahedron() << 1 << 0;
    QTest::newRow("cube") << shapes::cube(2) << 1 << 0;
    QTest::newRow("ball") << core::icosphere(4, 50) << 1 << 0;
    QTest::newRow("torus") << shapes::torus() << 1 << 1;
    QTest::newRow("two toruses") << shapes::together(shapes::torus(), shapes::moved(shapes::torus(), {9, 0, 0})) << 2
                                 << 2;
    QTest::newRow("ball with a cavity") << shapes::nestedSpheres(true) << 2 << 0;
    QTest::newRow("tiny") << shapes::scaled(core::icosphere(2, 1), 1e-30f) << 1 << 0;
    QTest::newRow("huge") << shapes::scaled(core::icosphere(2, 1), 1e30f) << 1 << 0;
}

void TestMeshCheck::soundShapes_areReady()
{
    QFETCH(TriangleMesh, mesh);
    QFETCH(int, components);
    QFETCH(int, genus);
    const MeshReport report = core::checkMesh(mesh);
    QVERIFY(report.closed && report.manifold && report.oriented);
    QCOMPARE(report.boundsSolid, std::optional(true));
    QCOMPARE(report.intersections.count, std::uint64_t(0));
    QCOMPARE(report.latticeOk, std::optional(true));
    QVERIFY(report.printReady());
    QCOMPARE(report.components, std::size_t(components));
    QCOMPARE(report.genus, std::optional<std::int64_t>(genus));
    QCOMPARE(report.vertices, mesh.points.size());
    QCOMPARE(report.faces, mesh.triangles.size());
    QVERIFY(*report.volume > 0);
    const MeshReport inside = core::checkMesh(shapes::reversed(mesh));
    QCOMPARE(inside.boundsSolid, std::optional(false));
    QVERIFY(!inside.printReady() && *inside.volume < 0);
}

void TestMeshCheck::brokenShapes_areNamed_data()
{
    using Counts = std::vector<std::uint64_t>;
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<QString>("flags"); // c(losed), m(anifold), o(riented), s(olid); "-": no, "?": not defined
    // numbers of open, non-manifold, misoriented edges, non-manifold vertices, intersections (if known)
    QTest::addColumn<Counts>("findings");
    const auto row = [](const char* name, const TriangleMesh& mesh, const char* flags, const Counts& findings) {
        QTest::newRow(name) << mesh << QString(flags) << findings;
    };
    row("open cone", shapes::openCone(7), "-mo?", {7, 0, 0, 0, 0});
    row("bow tie", shapes::bowTie(), "c-o?", {0, 0, 0, 1, 0});
    row("three faces at an edge", shapes::threeFacesAtEdge(), "---?", {6, 1, 0, 0, 0});
    row("flipped face", shapes::cubeWithFlippedFace(), "cm-?", {0, 0, 3, 0, 0});
    row("pushed through", shapes::pushedThroughTetrahedron(), "cmo-", {0, 0, 0, 0, 0});
    row("ball outwards in a ball", shapes::nestedSpheres(false), "cmo-", {0, 0, 0, 0, 0});
    row("touching", shapes::touchingCubes(), "cmo?", {0, 0, 0, 0});
    row("ball through ball", shapes::sphereThroughSphere(), "cmo?", {0, 0, 0, 0});
}

void TestMeshCheck::brokenShapes_areNamed()
{
    using Counts = std::vector<std::uint64_t>;
    QFETCH(TriangleMesh, mesh);
    QFETCH(QString, flags);
    QFETCH(Counts, findings);
    const MeshReport report = core::checkMesh(mesh);
    const auto flag = [](bool is, char letter) { return QString(is ? QChar(letter) : QChar('-')); };
    const QString solid = report.boundsSolid ? flag(*report.boundsSolid, 's') : "?";
    QCOMPARE(flag(report.closed, 'c') + flag(report.manifold, 'm') + flag(report.oriented, 'o') + solid, flags);
    Counts found{report.openEdges.count, report.nonManifoldEdges.count, report.misorientedEdges.count,
                 report.nonManifoldVertices.count};
    if (findings.size() > found.size())
        found.push_back(report.intersections.count);
    else
        QVERIFY(report.intersections.count > 0);
    QCOMPARE(found, findings);
    QVERIFY(!report.printReady());
    for (const core::Finding* finding :
         {&report.openEdges, &report.nonManifoldEdges, &report.misorientedEdges, &report.nonManifoldVertices})
        QCOMPARE(finding->firstFaces.empty(), finding->count == 0);
}

void TestMeshCheck::measures_areThoseOfTheShape()
{
    const MeshReport cube = core::checkMesh(shapes::moved(shapes::cube(2), {10, 0, 0}));
    QVERIFY(std::abs(*cube.volume - 8) < 1e-12);
    QVERIFY(std::abs(cube.area - 24) < 1e-12);
    QCOMPARE(cube.size, core::Vec3(2, 2, 2));
    QCOMPARE(cube.minEdge, 2.0);
    QCOMPARE(cube.maxEdge, std::sqrt(8.0));
    const MeshReport ball = core::checkMesh(core::icosphere(5, 10));
    QVERIFY(std::abs(*ball.volume / (4000 * std::numbers::pi / 3) - 1) < 1e-2);
    QVERIFY(!core::checkMesh(shapes::openCone(5)).volume);
    QVERIFY(!core::checkMesh(shapes::openCone(5)).genus);
}

void TestMeshCheck::unusedVertices_areLeftOut()
{
    TriangleMesh mesh = shapes::cube(2);
    mesh.points.push_back({1e30f, 0, 0});
    const MeshReport report = core::checkMesh(mesh);
    QVERIFY(report.printReady());
    QCOMPARE(report.vertices, std::size_t(8));
    QCOMPARE(report.unusedVertices, std::size_t(1));
    QCOMPARE(report.size.x(), 2.0);
}

void TestMeshCheck::noFaces_isNotReady()
{
    QVERIFY(!core::checkMesh({}).printReady());
    QVERIFY(!core::checkMesh({{{0, 0, 0}}, {}, {}}).printReady());
}

void TestMeshCheck::degenerateFaces_areFound()
{
    TriangleMesh mesh = shapes::cube(2);
    mesh.points.push_back({0, -1, -1}); // lies on an edge of the cube
    mesh.triangles.push_back({0, 1, 8});
    mesh.triangles.push_back({3, 3, 4});
    const MeshReport report = core::checkMesh(mesh);
    QCOMPARE(report.degenerateFaces.count, std::uint64_t(2));
    QCOMPARE(report.degenerateFaces.firstFaces, (std::vector<Slot>{12, 13}));
    QVERIFY(!report.printReady());
    QVERIFY(!report.latticeOk);
    TriangleMesh point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {}, {{0, 1, 2}}};
    QCOMPARE(core::checkMesh(point).degenerateFaces.count, std::uint64_t(1));
}

void TestMeshCheck::nesting_isJudgedByDepth()
{
    TriangleMesh shells;
    for (int depth = 0; depth < 6; ++depth) {
        const TriangleMesh cube = shapes::cube(static_cast<float>(20 - 2 * depth)); // corners exactly above each other
        shells = shapes::together(shells, depth % 2 ? shapes::reversed(cube) : cube);
        QVERIFY(core::checkMesh(shells).printReady());
        QVERIFY(!core::checkMesh(shapes::reversed(shells)).printReady());
    }
    QVERIFY(core::checkMesh(shapes::together(shells, shapes::cube(1))).printReady());
    QCOMPARE(core::checkMesh(shapes::together(shells, shapes::reversed(shapes::cube(1)))).boundsSolid,
             std::optional(false));
}

/// Tests tetrahedra whose volume rounds to 0 in double: their height is one unit of float precision, far from the
/// origin.
void TestMeshCheck::volumeSign_isExact()
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> coordinate(900, 1000);
    int flat = 0;
    for (int i = 0; i < 20'000; ++i) {
        TriangleMesh mesh = shapes::tetrahedron();
        for (Vec3f& p : mesh.points)
            p = {coordinate(engine), coordinate(engine), coordinate(engine)};
        // The fourth point is almost in the plane of the other three.
        const core::Vec3 a = mesh.points[0].cast<double>(), b = mesh.points[1].cast<double>(),
                         c = mesh.points[2].cast<double>();
        mesh.points[3] = (a + 0.3 * (b - a) + 0.4 * (c - a)).cast<float>();
        if (i % 2)
            mesh.points[3] = mesh.points[3].array() * 0x1p-20f;
        const int side = FloatPredicates::orient3d(mesh.points[0], mesh.points[1], mesh.points[2], mesh.points[3]);
        flat += side == 0;
        QCOMPARE(core::boundsSolid(mesh.points, mesh.triangles), side < 0);
    }
    qInfo("%d flat", flat);
}

void TestMeshCheck::orderOfElements_doesNotMatter()
{
    const TriangleMesh mesh = shapes::noisy(core::icosphere(3, 1), 0.08f, seed);
    const MeshReport report = core::checkMesh(mesh);
    QVERIFY(report.intersections.count > 0);
    for (unsigned i = 0; i < 10; ++i)
        QCOMPARE(core::checkMesh(shuffled(mesh, i)).intersections.count, report.intersections.count);
}

void TestMeshCheck::keptPairs_areTheFirst()
{
    const TriangleMesh mesh = shapes::noisy(core::icosphere(4, 1), 0.1f, seed);
    const auto all = core::selfIntersections<FloatPredicates>(mesh.points, mesh.triangles, 1'000'000);
    QVERIFY(all.count > 5000);
    QCOMPARE(all.pairs.size(), std::size_t(all.count));
    QVERIFY(std::is_sorted(all.pairs.begin(), all.pairs.end()));
    for (const std::size_t keep : {std::size_t(0), std::size_t(1), std::size_t(1000)}) {
        const auto some = core::selfIntersections<FloatPredicates>(mesh.points, mesh.triangles, keep);
        QCOMPARE(some.count, all.count);
        QVERIFY(std::equal(some.pairs.begin(), some.pairs.end(), all.pairs.begin(),
                           all.pairs.begin() + static_cast<std::ptrdiff_t>(keep)));
    }
}

void TestMeshCheck::equalFaces_areCountedAsOthers()
{
    TriangleMesh mesh = shapes::noisy(core::icosphere(2, 1), 0.1f, seed);
    std::mt19937 random(seed);
    const std::size_t faces = mesh.triangles.size();
    for (std::size_t i = 0; i < 3 * faces; ++i) { // up to about 30 copies of the same face
        core::Triangle t = mesh.triangles[random() % (i % 2 == 0 ? faces : 20)];
        std::shuffle(t.begin(), t.end(), random);
        mesh.triangles.push_back(t);
    }
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    const auto cornersOf = [&](const core::Triangle& t) {
        return core::CornerTriangle<FloatPredicates>{t, {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}};
    };
    std::vector<core::FacePair> expected;
    for (core::Slot a = 0; a < mesh.triangles.size(); ++a)
        for (core::Slot b = a + 1; b < mesh.triangles.size(); ++b)
            if (core::trianglesIntersect(cornersOf(mesh.triangles[a]), cornersOf(mesh.triangles[b])))
                expected.push_back({a, b});
    for (const std::size_t keep : {std::size_t(0), std::size_t(7), std::size_t(1000), 2 * expected.size()}) {
        const auto found = core::selfIntersections<FloatPredicates>(mesh.points, mesh.triangles, keep);
        QCOMPARE(found.count, expected.size());
        QCOMPARE(found.pairs.size(), std::min(keep, expected.size()));
        QVERIFY(std::equal(found.pairs.begin(), found.pairs.end(), expected.begin()));
    }
}

void TestMeshCheck::latticeAndFloatAgree()
{
    for (unsigned i = 0; i < 20; ++i) {
        const TriangleMesh mesh = rounded(shapes::noisy(core::icosphere(3, 1), 0.05f, i), 1 << 10);
        std::vector<LatticePoint> points;
        for (const Vec3f& p : mesh.points)
            points.push_back(p.cast<int>());
        const auto onLattice = core::selfIntersections<LatticePredicates>(points, mesh.triangles);
        const auto onFloats = core::selfIntersections<FloatPredicates>(mesh.points, mesh.triangles);
        QCOMPARE(onLattice.count, onFloats.count);
        QVERIFY(onLattice.pairs == onFloats.pairs);
        if (onLattice.count == 0)
            QCOMPARE(core::boundsSolid(points, mesh.triangles), core::boundsSolid(mesh.points, mesh.triangles));
    }
}

void TestMeshCheck::surfaceAndImage_areJudgedAsEachAlone()
{
    int imagesThatMeet = 0, surfacesThatMeet = 0;
    for (unsigned i = 0; i < 40; ++i) {
        const float noise = i % 2 == 0 ? 0 : 0.03F;
        const TriangleMesh mesh =
            shapes::scaled(shapes::noisy(core::icosphere(4, 1), noise, i), 20.0F + static_cast<float>(3 * i));
        std::vector<LatticePoint> image;
        for (const Vec3f& p : mesh.points)
            image.push_back(p.array().round().matrix().cast<int>());
        if (!core::degenerateFaces<LatticePredicates>(image, mesh.triangles).empty())
            continue;
        const auto surface = core::selfIntersections<FloatPredicates>(mesh.points, mesh.triangles, 100);
        const auto alone = core::selfIntersections<LatticePredicates>(image, mesh.triangles, 0);
        const auto both = core::selfIntersections(mesh.points, image, mesh.triangles, 100, {});
        QCOMPARE(both.surface.count, surface.count);
        QVERIFY(both.surface.pairs == surface.pairs);
        QCOMPARE(both.imageMeets, alone.count != 0);
        imagesThatMeet += both.imageMeets && surface.count == 0 ? 1 : 0;
        surfacesThatMeet += surface.count != 0 ? 1 : 0;
    }
    QVERIFY2(imagesThatMeet > 0 && surfacesThatMeet > 0,
             qPrintable(QStringLiteral("%1 %2").arg(imagesThatMeet).arg(surfacesThatMeet)));
}

void TestMeshCheck::lattice_tellsWhatImportWouldBreak()
{
    const TriangleMesh bubble = shapes::reversed(shapes::scaled(shapes::tetrahedron(), 1e-5f));
    const MeshReport merged = core::checkMesh(shapes::together(shapes::cube(1000), bubble));
    QVERIFY(merged.printReady());
    QCOMPARE(merged.latticeOk, std::optional(false));
    const MeshReport alone = core::checkMesh(shapes::moved(shapes::scaled(shapes::tetrahedron(), 0.01f), {0, 0, 700}));
    QCOMPARE(alone.latticeOk, std::optional(true)); // acceptable, because import moves the model to the origin
    QVERIFY(!core::checkMesh(shapes::sphereThroughSphere()).latticeOk);
    QCOMPARE(core::checkMesh(shapes::openCone(5)).latticeOk, std::optional(true));
}

void TestMeshCheck::placement_movesFarModels()
{
    core::Box box(core::Vec3(7, 7, 7), core::Vec3(9, 9, 9));
    // 13.9 from the origin; the limit is 4 times the size 2
    QVERIFY(core::placeOnLattice(box).moved != core::Vec3::Zero());
    box.translate(core::Vec3(-4, -4, -4));
    QVERIFY(core::placeOnLattice(box).moved == core::Vec3::Zero());
    const core::LatticePlacement placement = core::placeOnLattice(box, true);
    QCOMPARE(placement.moved, core::Vec3(-4, -4, -4));
    QCOMPARE(placement.toLattice({5, 5, 5}), placement.lattice.toLattice({1, 1, 1}));
}

void TestMeshCheck::randomShapes_agreeWithCgal_data()
{
    QTest::addColumn<std::function<TriangleMesh(unsigned)>>("make");
    const auto row = [](const char* name, const std::function<TriangleMesh(unsigned)>& make) {
        QTest::newRow(name) << make;
    };
    row("noisy balls", [](unsigned i) { return shapes::noisy(core::icosphere(2, 1), 0.01f * float(i % 20), i); });
    row("noisy toruses", [](unsigned i) { return shapes::noisy(shapes::torus(), 0.03f * float(i % 20), i); });
    row("coarse integers",
        [](unsigned i) { return rounded(shapes::noisy(core::icosphere(2, 1), 0.1f, i), float(2 + i % 12)); });
    row("balls here and there", randomBalls);
    row("nested balls", nestedBalls);
    row("ball and noisy torus", [](unsigned i) {
        return shuffled(
            shapes::together(core::icosphere(2, 1.5 + 0.03 * (i % 40)), shapes::noisy(shapes::torus(), 0.05f, i)), i);
    });
    row("holes and flips", [](unsigned i) {
        TriangleMesh mesh = shapes::noisy(core::icosphere(1, 1), 0.05f, i);
        mesh.triangles.erase(mesh.triangles.begin() + i % 50, mesh.triangles.begin() + i % 50 + i % 4);
        std::mt19937 engine(i);
        for (auto edits = engine() % 3; edits != 0; --edits)
            mesh.triangles[engine() % mesh.triangles.size()][engine() % 3] =
                static_cast<Slot>(engine() % mesh.points.size());
        return mesh;
    });
}

void TestMeshCheck::randomShapes_agreeWithCgal()
{
    QFETCH(std::function<TriangleMesh(unsigned)>, make);
    const unsigned rounds = byEffort(30u, 120u, 5000u);
    int ready = 0;
    for (unsigned i = 0; i < rounds; ++i) {
        const TriangleMesh mesh = make(i);
        const std::string difference = compareWithCgal(mesh);
        QVERIFY2(difference.empty(),
                 qPrintable(QString("round %1: %2").arg(i).arg(QString::fromStdString(difference))));
        ready += core::checkMesh(mesh).printReady();
    }
    qInfo("%d of %u are print-ready", ready, rounds);
}

FETTLE_TEST(TestMeshCheck)
#include "tst_mesh_check.moc"
