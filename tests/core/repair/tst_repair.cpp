// FETTLE_EFFORT=soak: tests 20,000 random defective models, about six hours of one core. FETTLE_SEED=n: first seed.
// FETTLE_MODELS=n: number of models.

#include "core/geometry/face_geometry.h"
#include "core/mesh/mesh_builder.h"
#include "core/mesh/mesh_hash.h"
#include "core/repair/repair.h"
#include "core/util/worker_pool.h"
#include "tests/support/bad_models.h"
#include "tests/support/cgal_judge.h"
#include "tests/support/effort.h"
#include "tests/support/environment.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <numbers>
#include <random>
#include <tuple>

using namespace core;
using namespace Qt::StringLiterals;

namespace
{
const BadModel& badModel(const QString& name)
{
    static const std::vector<BadModel> models = badModels();
    return *std::ranges::find(models, name.toStdString(), &BadModel::name);
}

std::uint64_t hashOf(const TriangleMesh& mesh)
{
    return wholeHash(*buildMesh(mesh).mesh);
}

/// Returns a random number from -1 to 1.
double unit(std::mt19937& random)
{
    return 2 * static_cast<double>(random()) / 0xffffffff - 1;
}

TriangleMesh turned(TriangleMesh mesh, std::mt19937& random)
{
    const Eigen::Vector3d axis(unit(random), unit(random), unit(random));
    const Eigen::Quaterniond rotation(Eigen::AngleAxisd(std::numbers::pi * unit(random), axis.normalized()));
    for (Vec3f& p : mesh.points)
        p = (rotation * p.cast<double>()).cast<float>();
    return mesh;
}

/// Returns a prism about the y axis between the heights `from` and `to`.
TriangleMesh prism(Slot sides, double radius, double from, double to)
{
    TriangleMesh mesh{{{0, static_cast<float>(from), 0}, {0, static_cast<float>(to), 0}}, {}, {}};
    for (Slot i = 0; i < sides; ++i)
        for (const double y : {from, to}) {
            const double angle = 2 * std::numbers::pi * i / sides;
            mesh.points.push_back(Vec3(radius * std::sin(angle), y, radius * std::cos(angle)).cast<float>());
        }
    for (Slot i = 0; i < sides; ++i) {
        const Slot a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % sides);
        mesh.triangles.insert(mesh.triangles.end(), {{0, b, a}, {1, a + 1, b + 1}, {a, b, b + 1}, {a, b + 1, a + 1}});
    }
    return mesh;
}

double volumeOf(const TriangleMesh& mesh)
{
    return checkMesh(mesh).volume.value_or(0);
}

/// Returns a random defective model. Either it consists of triangles, tetrahedra or cubes on a coarse grid, where
/// corners, edges and planes coincide.
/// Or it is a noisy ball or torus with faces reversed, repeated, removed or attached to wrong vertices.
TriangleMesh strangeModel(unsigned seed)
{
    std::mt19937 random(seed);
    const auto below = [&random](unsigned n) { return static_cast<Slot>(random() % n); };
    TriangleMesh mesh;
    const auto gridPoint = [&](unsigned n) {
        const auto x = static_cast<float>(below(n)), y = static_cast<float>(below(n)), z = static_cast<float>(below(n));
        return Vec3f(10 * x, 10 * y, 10 * z);
    };
    switch (seed % 4) {
    case 0:
        for (Slot i = 0; i < 30; ++i)
            mesh.points.push_back(gridPoint(4));
        for (unsigned i = 5 + below(40); i > 0; --i)
            mesh.triangles.push_back({below(30), below(30), below(30)});
        return mesh;
    case 1:
        for (unsigned i = 2 + below(8); i > 0; --i) {
            const auto o = static_cast<Slot>(mesh.points.size());
            for (int k = 0; k < 4; ++k)
                mesh.points.push_back(gridPoint(5));
            for (const Triangle& t : shapes::tetrahedron().triangles)
                mesh.triangles.push_back({o + t[0], o + t[1], o + t[2]});
        }
        return mesh;
    case 2:
        for (unsigned i = 2 + below(10); i > 0; --i)
            mesh = shapes::together(mesh, shapes::moved(shapes::cube(20), gridPoint(6)));
        return mesh;
    default:
        mesh = below(2) == 0 ? icosphere(2, 50) : shapes::torus({40, 15, 24, 12});
        mesh = shapes::noisy(mesh, 0.5f * static_cast<float>(below(20)), seed);
        for (Triangle& t : mesh.triangles) {
            if (below(50) == 0)
                std::swap(t[0], t[1]);
            if (below(80) == 0)
                t = mesh.triangles[below(static_cast<unsigned>(mesh.triangles.size()))];
            if (below(200) == 0)
                t[below(3)] = below(static_cast<unsigned>(mesh.points.size()));
        }
        std::erase_if(mesh.triangles, [&](const Triangle&) { return below(60) == 0; });
        return mesh;
    }
}
} // namespace

class TestRepair : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void badModels_becomeSolids_data();
    void badModels_becomeSolids();
    void soundModel_keepsItsPoints();
    void unions_haveTheVolumeOfTheUnion();
    void holes_areClosedAndNothingElseMoves();
    void largeHoles_areRefusedIfAsked();
    void innerParts_areFilledOrCavities();
    void touchingParts_partByMicrometres();
    void soup_isMadeAnewNearby();
    void cracks_areJoinedAndNothingElseMoves_data();
    void cracks_areJoinedAndNothingElseMoves();
    void distantRims_areNotJoined();
    void tangle_comesToAnEnd();
    void denseTangle_isRefusedAtOnce();
    void colors_stay();
    void masks_stayWherePointsDo();
    void masks_thatGoAreCounted();
    void nothingEnclosed_isRefused();
    void openSheets_areLeftOutAndNamed();
    void sheetsThatCross_areLeftOut();
    void wallsAroundSpace_areNotLeftOut_data();
    void wallsAroundSpace_areNotLeftOut();
    void lidOnAWell_isNoSheet();
    void skinsOfThinSolids_areNotSheets_data();
    void skinsOfThinSolids_areNotSheets();
    void looseFaces_areNotLost();
    void thinStrips_keepTheirVolume();
    void turnedParts_areRepairedAlike();
    void turnedCylinders_areOnePart();
    void turnedContacts_areRepairedAlike_data();
    void turnedContacts_areRepairedAlike();
    void roughEnds_areOnePart();
    void insideOutParts_areNotTakenAway();
    void filledHoles_areTold();
    void partsInHollows_areTold();
    void cutterInACutter_isCounted();
    void broadGround_isNotLostSilently();
    void voidsBetweenParts_stay();
    void lossOfVolume_isNotFaithful();
    void otherSpace_isNotFaithful();
    void openEnds_areFaithful();
    void farModel_isMovedAndSaid();
    void threads_doNotChangeTheOutcome();
    void stopped_hasNoMesh();
    void strangeModels_becomeSolidsOrAreRefused();
};

void TestRepair::badModels_becomeSolids_data()
{
    QTest::addColumn<QString>("name");
    for (const BadModel& bad : badModels())
        if (bad.name != "three faces at an edge")
            QTest::newRow(bad.name.c_str()) << QString::fromStdString(bad.name);
}

void TestRepair::badModels_becomeSolids()
{
    QFETCH(QString, name);
    const TriangleMesh& bad = badModel(name).mesh;
    QVERIFY(!checkMesh(bad).printReady());
    const RepairResult result = repairMesh(bad, {.canWrap = name == u"soup"});
    QVERIFY(result.mesh);
    QCOMPARE(result.report.isFaithful(), name != u"soup");
    const auto verdict = judgedByCgal(*result.mesh);
    QVERIFY(verdict && verdict->allWell());
    QVERIFY(buildMesh(*result.mesh).mesh);
    const double size = checkMesh(bad).size.maxCoeff();
    QVERIFY(result.report.fromOld.mean <= 0.05 * size);
    QVERIFY(result.report.fromOld.largest <= result.report.hausdorff());
}

void TestRepair::soundModel_keepsItsPoints()
{
    const TriangleMesh onLattice = extractMesh(*buildMesh(shapes::torus({40, 15, 40, 20})).mesh);
    const RepairResult result = repairMesh(onLattice);
    QVERIFY(result.mesh);
    QCOMPARE(hashOf(*result.mesh), hashOf(onLattice));
    QCOMPARE(result.report.hausdorff(), 0.0);
}

void TestRepair::unions_haveTheVolumeOfTheUnion()
{
    const auto volume = [](const char* name) { return volumeOf(*repairMesh(badModel(QLatin1String(name)).mesh).mesh); };
    QVERIFY(std::abs(volume("coplanar overlap") - (2 * 64000 - 20 * 30 * 40)) < 1);
    QVERIFY(std::abs(volume("stacked cubes") - 2 * 64000) < 1);
    QVERIFY(std::abs(volume("crossing cubes") - (2 * 64000 - 20 * 20 * 20)) < 1);
    QVERIFY(std::abs(volume("membrane") - 60 * 60 * 60) < 1);
    const double whole = volumeOf(icosphere(4, 50));
    for (const char* name : {"flipped faces", "inside out", "duplicate faces", "slivers"})
        QVERIFY2(std::abs(volume(name) - whole) < 1, name);
}

void TestRepair::holes_areClosedAndNothingElseMoves()
{
    const RepairResult result = repairMesh(badModel(QStringLiteral("holes")).mesh);
    QCOMPARE(result.report.holes, std::size_t(2));
    QCOMPARE(result.report.largeHoles, std::size_t(0));
    QVERIFY(result.report.fromOld.largest < 1e-4);
    QVERIFY(result.report.fromNew.largest < 12);
}

void TestRepair::largeHoles_areRefusedIfAsked()
{
    const RepairResult result = repairMesh(badModel(QStringLiteral("open bowl")).mesh, {.fillLargeHoles = false});
    QVERIFY(!result.mesh);
    QVERIFY(result.refusal == RepairRefusal::LargeHoles);
    QCOMPARE(result.report.largeHoles, std::size_t(1));
    QVERIFY(repairMesh(badModel(QStringLiteral("holes")).mesh, {.fillLargeHoles = false}).mesh);
    TriangleMesh open = shapes::moved(shapes::cube(40), {5000, 300, 0});
    open.triangles.resize(open.triangles.size() - 2); // without the side at x = 4980
    const RepairResult refused = repairMesh(open, {.fillLargeHoles = false});
    QVERIFY(refused.place && (*refused.place - Vec3(4980, 300, 0)).norm() < 0.01);
    QVERIFY(!repairMesh(open).place);
}

void TestRepair::innerParts_areFilledOrCavities()
{
    const TriangleMesh& bad = badModel(QStringLiteral("inner shells")).mesh;
    const RepairResult filled = repairMesh(bad), hollow = repairMesh(bad, {.innerAreCavities = true});
    QCOMPARE(filled.report.innerParts, std::size_t(2));
    QCOMPARE(checkMesh(*filled.mesh).components, std::size_t(1));
    QCOMPARE(checkMesh(*hollow.mesh).components, std::size_t(3));
    const double inner = volumeOf(icosphere(3, 20)) + volumeOf(icosphere(2, 5));
    QVERIFY(std::abs(volumeOf(*filled.mesh) - volumeOf(*hollow.mesh) - inner) < 1);
    const TriangleMesh right = shapes::scaled(shapes::nestedSpheres(true), 20); // a correct cavity stays a cavity
    QVERIFY(std::abs(volumeOf(*repairMesh(right).mesh) - volumeOf(right)) < 1);
}

void TestRepair::touchingParts_partByMicrometres()
{
    for (const char* name : {"non-manifold edge", "non-manifold vertex", "bow tie", "touching cubes"}) {
        const RepairResult result = repairMesh(badModel(QLatin1String(name)).mesh);
        QVERIFY2(result.mesh, name);
        QVERIFY2(result.report.touchingEdges + result.report.touchingVertices > 0, name);
        QVERIFY2(result.report.hausdorff() < 0.01, name);
        QCOMPARE(checkMesh(*result.mesh).components, std::size_t(2));
    }
}

void TestRepair::soup_isMadeAnewNearby()
{
    const TriangleMesh& soup = badModel(QStringLiteral("soup")).mesh;
    QVERIFY(!repairMesh(soup).mesh); // wrapping needs permission
    const RepairResult result = repairMesh(soup, {.canWrap = true});
    QVERIFY(result.report.remeshedAt);
    QVERIFY(!result.report.isFaithful());
    QCOMPARE(result.report.joined, std::size_t(0)); // faces that are near by chance are not joined as cracks
    QVERIFY(result.report.hausdorff() < 2 * *result.report.remeshedAt);
    QVERIFY(result.report.fromOld.mean < 0.1);
    QCOMPARE(checkMesh(*result.mesh).genus, std::optional<std::int64_t>(0));
}

void TestRepair::cracks_areJoinedAndNothingElseMoves_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("farthest");
    QTest::addColumn<qulonglong>("vertices");
    // `farthest`: largest distance in mm between joined points, and between the surfaces before and after
    QTest::newRow("everywhere") << u"cracked everywhere"_s << 0.0104 << qulonglong(642);
    QTest::newRow("seam") << u"cracked seam"_s << 0.0055 << qulonglong(2562);
    QTest::newRow("T junctions") << u"T junctions"_s << 0.02 << qulonglong(0);
}

void TestRepair::cracks_areJoinedAndNothingElseMoves()
{
    QFETCH(QString, name);
    QFETCH(double, farthest);
    QFETCH(qulonglong, vertices);
    const TriangleMesh& cracked = badModel(name).mesh;
    const RepairResult result = repairMesh(cracked);
    QVERIFY(result.mesh);
    QVERIFY(result.report.joined > 0);
    QVERIFY(result.report.joinedWithin > 0.001 && result.report.joinedWithin <= farthest);
    QCOMPARE(result.report.holes, std::size_t(0));
    QVERIFY(!result.report.remeshedAt);
    QVERIFY(result.report.hausdorff() <= farthest);
    const MeshReport report = checkMesh(*result.mesh);
    QCOMPARE(report.components, std::size_t(1));
    QCOMPARE(report.genus, std::optional<std::int64_t>(0));
    if (vertices > 0)
        QCOMPARE(result.mesh->points.size(), std::size_t(vertices));
    QVERIFY(!repairMesh(cracked, {.fillLargeHoles = false}).report.largeHoles); // the joined cracks were no large holes
}

/// Rims farther apart than a crack, and points within the surface, must not be joined.
void TestRepair::distantRims_areNotJoined()
{
    TriangleMesh upper = icosphere(3, 50), lower = upper;
    std::erase_if(upper.triangles, [&](const Triangle& t) { return lower.points[t[0]].y() <= 0; });
    std::erase_if(lower.triangles, [&](const Triangle& t) { return lower.points[t[0]].y() > 0; });
    const RepairResult apart = repairMesh(shapes::together(upper, shapes::moved(lower, {0, -1, 0})));
    QCOMPARE(apart.report.joined, std::size_t(0));
    QVERIFY(apart.report.holes > 0);
    const TriangleMesh balls = shapes::together(icosphere(3, 50), shapes::moved(icosphere(3, 50), {100.001f, 0, 0}));
    const RepairResult near = repairMesh(balls);
    QCOMPARE(near.report.joined, std::size_t(0));
    QCOMPARE(checkMesh(*near.mesh).components, std::size_t(2));
}

/// Rounding used to create more intersections of this model in each round, for twenty minutes.
void TestRepair::tangle_comesToAnEnd()
{
    const RepairResult result = repairMesh(strangeModel(93));
    QVERIFY(result.mesh);
    const auto verdict = judgedByCgal(*result.mesh);
    QVERIFY(verdict && verdict->allWell());
}

/// Each face meets about 130 faces of other tetrahedra at the same place. Cutting them apart would take minutes.
void TestRepair::denseTangle_isRefusedAtOnce()
{
    StrokeFuzzer random(1);
    TriangleMesh tangle;
    for (int i = 0; i < 500; ++i) {
        TriangleMesh one = shapes::tetrahedron();
        for (Vec3f& p : one.points)
            p = (random.uniform(5, 8) * random.direction()).cast<float>();
        tangle = shapes::together(tangle, one);
    }
    const RepairResult result = repairMesh(tangle);
    QVERIFY(!result.mesh && result.place);
    QVERIFY(result.refusal == RepairRefusal::Unresolved);
}

void TestRepair::colors_stay()
{
    TriangleMesh bad = badModel(QStringLiteral("crossing shells")).mesh;
    for (const Vec3f& p : bad.points)
        bad.colors.push_back(p.x() < 20 ? Rgb{200, 0, 0} : Rgb{0, 0, 200});
    const TriangleMesh mesh = *repairMesh(bad).mesh;
    QCOMPARE(mesh.colors.size(), mesh.points.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        if (mesh.points[v].x() < 10)
            QVERIFY((mesh.colors[v] == Rgb{200, 0, 0}));
        if (mesh.points[v].x() > 30)
            QVERIFY((mesh.colors[v] == Rgb{0, 0, 200}));
    }
}

/// Points of a ball with a hole and duplicate faces must keep their own masks.
void TestRepair::masks_stayWherePointsDo()
{
    TriangleMesh bad = icosphere(3, 50);
    bad.triangles.pop_back();
    for (const Vec3f& p : bad.points)
        bad.masks.push_back(p.x() > 10 ? static_cast<std::uint8_t>(p.x() * 5) : std::uint8_t(0));
    bad = shapes::together(bad, bad);
    bad.masks.resize(bad.points.size(), 1);
    const RepairResult result = repairMesh(bad);
    QVERIFY(result.mesh && result.report.welded > 0);
    QCOMPARE(result.report.unmasked, std::size_t(0));
    const TriangleMesh& mesh = *result.mesh;
    QCOMPARE(mesh.masks.size(), mesh.points.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const float x = mesh.points[v].x();
        QVERIFY(std::abs(mesh.masks[v] - (x > 10 ? 5 * x : 1)) <= 1);
    }
}

void TestRepair::masks_thatGoAreCounted()
{
    TriangleMesh bad = badModel(QStringLiteral("soup")).mesh;
    bad.masks.assign(bad.points.size(), 255);
    const RepairResult result = repairMesh(bad, {.canWrap = true});
    QVERIFY(result.mesh && result.report.remeshedAt);
    QVERIFY(result.report.unmasked > bad.points.size() / 2 && result.report.unmasked <= bad.points.size());
    bad.masks.clear();
    QVERIFY(repairMesh(bad, {.canWrap = true}).mesh->masks.empty());
}

void TestRepair::nothingEnclosed_isRefused()
{
    const TriangleMesh point{{{1, 1, 1}}, {}, {{0, 0, 0}}};
    const TriangleMesh sheet{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {}, {{0, 1, 2}}};
    const TriangleMesh bent{{{0, 0, 0}, {9, 0, 0}, {9, 3, 0.01f}, {3, 3, 0}, {3, 9, 0}, {0, 9, 0.01f}},
                            {},
                            {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}};
    const TriangleMesh cards = shapes::together(bent, shapes::moved(bent, {20, 1, 3}));
    for (const TriangleMesh& mesh :
         {point, sheet, bent, cards, badModel(QStringLiteral("three faces at an edge")).mesh}) {
        const RepairResult result = repairMesh(mesh);
        QVERIFY(!result.mesh);
        QVERIFY(result.refusal == RepairRefusal::EnclosesNothing);
    }
}

/// A cube cut by an open floor, 1 mm below the cube's centre.
void TestRepair::openSheets_areLeftOutAndNamed()
{
    TriangleMesh floor{{{-50, -1, -50}, {150, -1, -50}, {150, -1, 100}, {-50, -1, 100}}, {}, {{0, 1, 2}, {0, 2, 3}}};
    const TriangleMesh cube = shapes::cube(40);
    const RepairResult result = repairMesh(shapes::together(cube, floor));
    QVERIFY(result.mesh);
    QCOMPARE(result.report.sheets, std::size_t(1));
    QVERIFY(std::abs(result.report.sheetLength - 200) < 0.001 && std::abs(result.report.sheetWidth - 150) < 0.001);
    QVERIFY(result.report.isFaithful());
    QCOMPARE(result.mesh->triangles.size(), cube.triangles.size());
    QVERIFY(std::abs(volumeOf(*result.mesh) - 64000) < 0.1);
    QCOMPARE(result.report.after.parts, std::size_t(1));

    TriangleMesh scene = shapes::together(cube, floor); // adds a narrow strip and rotates everything
    for (const Vec3f& p : {Vec3f(60, 20, 0), Vec3f(160, 20, 0), Vec3f(160, 21, 0), Vec3f(60, 21, 0)})
        scene.points.push_back(p);
    const Slot last = static_cast<Slot>(scene.points.size() - 1);
    scene.triangles.push_back({last - 3, last - 2, last - 1});
    scene.triangles.push_back({last - 3, last - 1, last});
    const Eigen::AngleAxisf turn(0.7F, Vec3f(1, 2, 3).normalized());
    for (Vec3f& p : scene.points)
        p = turn * p;
    const RepairResult turned = repairMesh(scene);
    QVERIFY(turned.mesh && turned.report.isFaithful());
    QCOMPARE(turned.report.sheets, std::size_t(2));
    QVERIFY(std::abs(turned.report.sheetLength - 200) < 0.01 && std::abs(turned.report.sheetWidth - 150) < 0.01);

    const RepairResult alone = repairMesh(floor, {.canWrap = true});
    QVERIFY(!alone.mesh);
    QVERIFY(alone.refusal == RepairRefusal::EnclosesNothing);
    QCOMPARE(alone.report.sheets, std::size_t(1));

    TriangleMesh withFin = cube; // a fin at one of the cube's edges
    Triangle fin = cube.triangles[0];
    const Vec3f onEdge = (cube.points[fin[0]] + cube.points[fin[1]]) / 2;
    const Vec3f middle = boxOf(cube).center().cast<float>();
    withFin.points.push_back(middle + 2 * (onEdge - middle));
    fin[2] = static_cast<Slot>(withFin.points.size() - 1);
    withFin.triangles.push_back(fin);
    const RepairResult trimmed = repairMesh(withFin);
    QVERIFY(trimmed.mesh && trimmed.report.isFaithful());
    QCOMPARE(trimmed.report.sheets, std::size_t(1));
    QCOMPARE(trimmed.mesh->triangles.size(), cube.triangles.size());
}

/// Each of two sheets beside a cube is in the way of the other, because they cross at some angle.
void TestRepair::sheetsThatCross_areLeftOut()
{
    const TriangleMesh cube = shapes::cube(40);
    const TriangleMesh sheet{{{-15, -15, 0}, {15, -15, 0}, {15, 15, 0}, {-15, 15, 0}}, {}, {{0, 1, 2}, {0, 2, 3}}};
    const auto expectCube = [&](TriangleMesh other) {
        const TriangleMesh both = shapes::moved(shapes::together(sheet, std::move(other)), {90, 0, 0});
        const RepairResult result = repairMesh(shapes::together(cube, both));
        QVERIFY(result.mesh && result.report.isFaithful());
        QCOMPARE(result.report.sheets, std::size_t(2));
        QCOMPARE(result.mesh->triangles.size(), cube.triangles.size());
    };
    for (unsigned seed = 1; seed <= 20; ++seed) {
        StrokeFuzzer random(seed);
        const Eigen::AngleAxisd turn(random.uniform(0.5, 2.6), random.direction());
        TriangleMesh other = sheet;
        for (Vec3f& p : other.points)
            p = (turn * p.cast<double>()).cast<float>();
        expectCube(other);
        if (QTest::currentTestFailed())
            QFAIL(qPrintable(QStringLiteral("seed %1").arg(seed)));
    }
}

/// Returns the faces of a mesh in pairs, each pair on its own and a little smaller.
TriangleMesh wallsOf(const TriangleMesh& mesh)
{
    TriangleMesh walls;
    for (std::size_t f = 0; f < mesh.triangles.size(); f += 2) {
        TriangleMesh wall{mesh.points, {}, {mesh.triangles[f], mesh.triangles[f + 1]}};
        Box box;
        for (const Triangle& t : wall.triangles)
            for (const Slot v : t)
                box.extend(wall.points[v].cast<double>());
        for (Vec3f& p : wall.points)
            p = (box.center() + 0.97 * (p.cast<double>() - box.center())).cast<float>();
        walls = shapes::together(walls, wall);
    }
    return walls;
}

void TestRepair::wallsAroundSpace_areNotLeftOut_data()
{
    QTest::addColumn<TriangleMesh>("walls");
    const TriangleMesh room = wallsOf(shapes::cube(40));
    const auto beside = [&](float x, float z) { return shapes::moved(room, {x, 0, z}); };
    QTest::addRow("a room") << room;
    QTest::addRow("two rooms") << shapes::together(room, beside(60, 0));
    TriangleMesh yard = room;
    for (const auto& [x, z] : {std::pair(0, 45), {0, 90}, {45, 90}, {90, 90}, {90, 45}, {90, 0}})
        yard = shapes::together(yard, beside(static_cast<float>(x), static_cast<float>(z)));
    QTest::addRow("rooms around a yard") << yard;
}

/// Walls that do not touch stand around rooms beside a cube. They are lost, but not as sheets.
void TestRepair::wallsAroundSpace_areNotLeftOut()
{
    QFETCH(TriangleMesh, walls);
    const RepairResult result = repairMesh(shapes::together(shapes::cube(40), shapes::moved(walls, {90, 0, 0})));
    QCOMPARE(result.report.sheets, std::size_t(0));
    QVERIFY(!result.mesh || !result.report.isFaithful());
}

/// Returns the inner and the outer skin of a tray of 100 x 100 without a rim, 1 thick.
TriangleMesh tray(float height)
{
    const auto skin = [](const Vec3f& sizes, float bottom) {
        TriangleMesh mesh = shapes::cube(1);
        for (Vec3f& p : mesh.points)
            p = (p + Vec3f(0, 0, 0.5F)).cwiseProduct(sizes) + Vec3f(0, 0, bottom);
        std::erase_if(mesh.triangles, [&](const Triangle& t) {
            return std::ranges::all_of(t, [&](Slot v) { return mesh.points[v].z() > bottom + sizes.z() / 2; });
        });
        return mesh;
    };
    return shapes::together(skin({100, 100, height}, 0), shapes::reversed(skin({98, 98, height - 1}, 1)));
}

/// Returns a sheet of count x count squares in the plane z = 0.
TriangleMesh sheetOf(Slot count, float side)
{
    TriangleMesh mesh;
    for (Slot i = 0; i <= count; ++i)
        for (Slot k = 0; k <= count; ++k)
            mesh.points.emplace_back(side * (static_cast<float>(i) / static_cast<float>(count) - 0.5F),
                                     side * (static_cast<float>(k) / static_cast<float>(count) - 0.5F), 0);
    for (Slot i = 0; i < count; ++i)
        for (Slot k = 0; k < count; ++k) {
            const Slot a = i * (count + 1) + k, b = a + count + 1;
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
        }
    return mesh;
}

/// A slab lies on the mouth of a shaft through a plate. Four faces meet at each edge of the mouth. The slab's upper
/// side lacks a triangle.
void TestRepair::lidOnAWell_isNoSheet()
{
    TriangleMesh mesh;
    const auto add = [&](std::initializer_list<Vec3f> corners) { // of a convex polygon
        const auto first = static_cast<Slot>(mesh.points.size());
        mesh.points.insert(mesh.points.end(), corners);
        for (Slot i = 2; i < corners.size(); ++i)
            mesh.triangles.push_back({first, first + i - 1, first + i});
    };
    constexpr float far = 50, near = 20, low = 0, high = 10, lid = 11;
    const Vec3f turns[] = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto at = [](const Vec3f& turn, float reach, float z) {
            return Vec3f(reach * turn + z * Vec3f::UnitZ());
        };
        const Vec3f &a = turns[i], &b = turns[(i + 1) % 4];
        add({at(a, far, low), at(b, far, low), at(b, far, high), at(a, far, high)});
        add({at(a, near, low), at(a, near, high), at(b, near, high), at(b, near, low)});
        add({at(a, far, high), at(b, far, high), at(b, near, high), at(a, near, high)});
        add({at(a, far, low), at(a, near, low), at(b, near, low), at(b, far, low)});
        add({at(a, near, high), at(b, near, high), at(b, near, lid), at(a, near, lid)});
    }
    add({{near, near, high}, {near, -near, high}, {-near, -near, high}, {-near, near, high}});
    add({{near, near, lid}, {-near, near, lid}, {-near, -near, lid}});
    const RepairResult result = repairMesh(mesh);
    QVERIFY(result.mesh);
    QCOMPARE(result.report.sheets, std::size_t(0));
    QVERIFY(std::abs(volumeOf(*result.mesh) / (84e3 + 1.6e3) - 1) < 1e-3);
}

void TestRepair::skinsOfThinSolids_areNotSheets_data()
{
    QTest::addColumn<TriangleMesh>("model");
    QTest::addColumn<double>("volume");
    QTest::addColumn<bool>("hasSheets");
    const double low = 1e4 * 2 - 98.0 * 98, flat = 1e4 * 3 - 98.0 * 98 * 2;
    const TriangleMesh large = shapes::moved(shapes::cube(200), {250, 0, 0}),
                       above = shapes::moved(tray(3), {0, 0, 20});
    QTest::addRow("a low tray") << tray(2) << low << false;
    QTest::addRow("beside a large cube") << shapes::together(large, tray(2)) << low + 8e6 << false;
    QTest::addRow("a plate of two skins that face the same way")
        << shapes::together(
               shapes::cube(40),
               shapes::moved(shapes::together(sheetOf(1, 100), shapes::moved(sheetOf(1, 100), {0, 0, 6})), {0, 0, 60}))
        << 64e3 << true;
    QTest::addRow("two finely divided skins that face the same way")
        << shapes::together(
               shapes::cube(40),
               shapes::moved(shapes::together(sheetOf(64, 100), shapes::moved(sheetOf(64, 100), {0, 0, 10})),
                             {0, 0, 60}))
        << 64e3 << true;
    QTest::addRow("two trays") << shapes::together(tray(3), above) << 2 * flat << false;
    QTest::addRow("two trays, one inside out")
        << shapes::together(tray(3), shapes::reversed(above)) << 2 * flat << false;
    for (const Slot count : {1U, 40U}) {
        const TriangleMesh sheet = sheetOf(count, count == 1 ? 160 : 30);
        TriangleMesh other = sheet;
        for (Vec3f& p : other.points)
            p = {p.x(), 0, p.y()};
        const TriangleMesh cross = shapes::moved(shapes::together(sheet, other), {0, 0, count == 1 ? -120.F : -40.F});
        QTest::addRow("beside crossing sheets of %u squares", count * count)
            << shapes::together(cross, tray(3)) << flat << true;
    }
}

/// The inner and the outer skin of a tray without a rim need only each other. They stay even if sheets near them are
/// told as lost.
void TestRepair::skinsOfThinSolids_areNotSheets()
{
    QFETCH(TriangleMesh, model);
    QFETCH(double, volume);
    const RepairResult result = repairMesh(model);
    QFETCH(bool, hasSheets);
    QVERIFY(result.mesh);
    QCOMPARE(result.report.isFaithful(), !hasSheets);
    QVERIFY(hasSheets || result.report.sheets == 0);
    QVERIFY2(std::abs(volumeOf(*result.mesh) - volume) < 1, qPrintable(QString::number(volumeOf(*result.mesh))));
}

/// The model consists of the separated faces of a cube.
void TestRepair::looseFaces_areNotLost()
{
    const TriangleMesh mesh = shapes::takenApart(shapes::cube(40), 4);
    const RepairResult result = repairMesh(mesh);
    QVERIFY(!result.mesh); // without wrapping nothing encloses a volume
    QCOMPARE(result.report.sheets, std::size_t(0));
    QVERIFY(result.refusal == RepairRefusal::TooMuchLost || result.refusal == RepairRefusal::EnclosesNothing);
    const RepairResult anew = repairMesh(mesh, {.canWrap = true});
    QVERIFY(anew.mesh && anew.report.remeshedAt);
    QVERIFY(volumeOf(*anew.mesh) > 40 * 40 * 40);
}

/// Two plates of 1.2 mm cross at an angle of 0.1 degrees. Neither may be lost, even if both are inside out.
void TestRepair::thinStrips_keepTheirVolume()
{
    const auto strip = [](float tilt) {
        TriangleMesh mesh = shapes::cube(1);
        for (Vec3f& p : mesh.points)
            p = Vec3f(300 * p.x(), 1.2f * p.y() + tilt * p.x(), 400 * p.z());
        return mesh;
    };
    for (const bool isInsideOut : {false, true}) {
        TriangleMesh mesh = shapes::together(strip(-0.25f), strip(0.25f));
        if (isInsideOut)
            mesh = shapes::reversed(mesh);
        const RepairResult result = repairMesh(mesh);
        QVERIFY(result.mesh && result.report.isFaithful());
        QVERIFY(volumeOf(*result.mesh) > 300 * 400 * 1.2);
    }
}

/// Boxes on a coarse grid share faces, edges and corners. After a rotation, rounding moves common planes apart.
void TestRepair::turnedParts_areRepairedAlike()
{
    const unsigned parts = byEffort(4, 20, 20), turns = byEffort(5, 30, 30);
    for (unsigned seed = 1; seed <= parts; ++seed) {
        std::mt19937 random(seed);
        const auto below = [&random](unsigned n) { return static_cast<float>(random() % n); };
        TriangleMesh part;
        for (unsigned i = 3 + seed % 4; i > 0; --i) {
            TriangleMesh box = shapes::cube(10);
            const Vec3f sides(1 + below(3), 1 + below(3), 1 + below(3)), at(below(4), below(4), below(4));
            for (Vec3f& p : box.points)
                p = p.cwiseProduct(sides) + 10 * at;
            part = shapes::together(part, box);
        }
        const RepairResult straight = repairMesh(part);
        QVERIFY2(straight.mesh || checkMesh(part).printReady(), qPrintable(QString::number(seed)));
        const double volume = straight.mesh ? volumeOf(*straight.mesh) : volumeOf(part);
        const std::size_t components = straight.mesh ? straight.report.after.parts : checkMesh(part).components;
        // Rounding decides whether parts are joined that touch only at an edge.
        const bool isDecided = straight.report.touchingEdges + straight.report.touchingVertices == 0;
        for (unsigned turn = 0; turn < turns; ++turn) {
            const RepairResult result = repairMesh(turned(part, random));
            const QByteArray which = "part " + QByteArray::number(seed) + " turn " + QByteArray::number(turn);
            QVERIFY2(result.mesh && result.report.isFaithful(), which.constData());
            QVERIFY2(std::abs(volumeOf(*result.mesh) - volume) < 1e-3 * volume, which.constData());
            QVERIFY2(!isDecided || result.report.after.parts == components, which.constData());
            if (turn == 0) {
                const auto verdict = judgedByCgal(*result.mesh);
                QVERIFY2(verdict && verdict->allWell(), which.constData());
            }
        }
    }
}

void TestRepair::turnedContacts_areRepairedAlike_data()
{
    QTest::addColumn<TriangleMesh>("model");

    const auto grid = [](int cells, float height, bool isUp) {
        TriangleMesh side;
        for (int i = 0; i <= cells; ++i)
            for (int k = 0; k <= cells; ++k)
                side.points.push_back(30.f / static_cast<float>(cells) * Vec3f(float(i), 0, float(k)) +
                                      Vec3f(0, height, 0));
        for (int i = 0; i < cells; ++i)
            for (int k = 0; k < cells; ++k) {
                const auto a = static_cast<Slot>(i * (cells + 1) + k), b = a + static_cast<Slot>(cells) + 1;
                side.triangles.insert(side.triangles.end(), {{a, a + 1, b + 1}, {a, b + 1, b}});
            }
        return isUp ? side : shapes::reversed(side);
    };
    const TriangleMesh plate = shapes::moved(prism(4, 40, -6, 0), {15, 0, 15});
    TriangleMesh studs = plate;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            studs = shapes::together(studs, shapes::moved(prism(7, 3, 0, 2), {8.f * float(i), 0, 8.f * float(k)}));
    TriangleMesh coins;
    for (Slot i = 0; i < 6; ++i)
        coins = shapes::together(coins, prism(30 + i, 10, 2. * i, 2. * i + 2));
    QTest::newRow("odd stack") << shapes::together(shapes::together(prism(37, 20, 0, 5), prism(23, 8, 5, 20)),
                                                   prism(11, 4, 20, 30));
    QTest::newRow("studs on a plate") << studs;
    QTest::newRow("coins on coins") << coins;
    QTest::newRow("small on large") << shapes::together(shapes::moved(shapes::cube(5), {60, 0, 80}),
                                                        shapes::moved(prism(4, 500, -20, 0), {0, 0, 0}));
    const TriangleMesh foil = prism(4, 300, -0.3, 0);
    TriangleMesh large = shapes::together(foil, shapes::moved(prism(9, 20, 0, 30), {70, 0, 60}));
    QTest::newRow("stud under and over a foil")
        << shapes::together(large, shapes::moved(prism(9, 20, -30.3, -0.3), {-70, 0, 60}));
    // A body hovers nearer than the offset over a face that another body touches.
    large = shapes::together(large, shapes::moved(prism(9, 20, 0, 30), {-70, 0.005F, -60}));
    QTest::newRow("a stud hovers") << large;
    QTest::newRow("sheet of two sides beside crossing plates")
        << shapes::together(shapes::together(grid(3, 20, true), grid(4, 20, false)),
                            shapes::together(plate, shapes::moved(prism(4, 10, -3, 3), {15, 0, 15})));
}

void TestRepair::turnedContacts_areRepairedAlike()
{
    constexpr double maxDifference = 1e-3;
    QFETCH(const TriangleMesh, model);

    const RepairResult straight = repairMesh(model);
    QVERIFY(straight.mesh);
    const SurfaceMeasures& expected = straight.report.after;
    std::mt19937 random(1);
    for (int turn = 0; turn < byEffort(6, 30, 30); ++turn) {
        const RepairResult result = repairMesh(turned(model, random));
        QVERIFY2(result.mesh, qPrintable(QString::number(turn)));
        const SurfaceMeasures& found = result.report.after;
        QCOMPARE(result.report.isFaithful(), straight.report.isFaithful());
        QCOMPARE(found.parts, expected.parts);
        QVERIFY2(std::abs(found.volume - expected.volume) < maxDifference * expected.volume,
                 qPrintable(QString::number(turn)));
        QVERIFY2(std::abs(found.area - expected.area) < maxDifference * expected.area,
                 qPrintable(QString::number(turn)));
    }
}

/// Three stacked cylinders, in any orientation, must become one part without small remains where they touch.
void TestRepair::turnedCylinders_areOnePart()
{
    const auto cylinder = [](double radius, double from, double to) { return prism(48, radius, from, to); };
    const TriangleMesh stack =
        shapes::together(shapes::together(cylinder(20, 0, 5), cylinder(8, 5, 20)), cylinder(4, 20, 30));
    const double volume = volumeOf(cylinder(20, 0, 5)) + volumeOf(cylinder(8, 5, 20)) + volumeOf(cylinder(4, 20, 30));
    std::mt19937 random(1);
    for (int turn = 0; turn < byEffort(6, 30, 30); ++turn) {
        const RepairResult result = repairMesh(turned(stack, random));
        QVERIFY2(result.mesh && result.report.isFaithful(), qPrintable(QString::number(turn)));
        QCOMPARE(result.report.after.parts, std::size_t(1));
        QVERIFY2(std::abs(volumeOf(*result.mesh) - volume) < 1e-3 * volume, qPrintable(QString::number(turn)));
    }
}

/// Two coaxial prisms of 24 and 32 sides have ends in the same plane, except for noise of about 20 lattice units.
/// The ends are fans of slivers. Some of these models cannot be cut with the first tolerance.
void TestRepair::roughEnds_areOnePart()
{
    constexpr double noise = 2e-4; // about 20 lattice units
    const auto fans = [](Slot sides, double phase) {
        TriangleMesh mesh;
        for (Slot i = 0; i < sides; ++i) {
            const double angle = phase + 2 * std::numbers::pi * i / sides;
            for (const double z : {0.0, 10.0})
                mesh.points.push_back(Vec3(10 * std::cos(angle), 10 * std::sin(angle), z).cast<float>());
            const Slot a = 2 * i, b = 2 * ((i + 1) % sides);
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
            if (i > 0 && i + 1 < sides)
                mesh.triangles.insert(mesh.triangles.end(), {{0, b, a}, {1, a + 1, b + 1}});
        }
        return mesh;
    };
    const TriangleMesh outer = fans(32, std::numbers::pi / 24), pair = shapes::together(outer, fans(24, 0));
    for (unsigned seed = 1; seed <= static_cast<unsigned>(byEffort(12, 400, 400)); ++seed) {
        std::mt19937 random(seed);
        TriangleMesh rough = turned(pair, random);
        for (Vec3f& p : rough.points)
            p += (noise * Vec3(unit(random), unit(random), unit(random))).cast<float>();
        const RepairResult result = repairMesh(rough);
        QVERIFY2(result.mesh && result.report.isFaithful(), qPrintable(QString::number(seed)));
        QCOMPARE(result.report.after.parts, std::size_t(1));
        QVERIFY2(volumeOf(*result.mesh) > 0.999 * volumeOf(outer), qPrintable(QString::number(seed)));
    }
}

/// A beam that faces inwards passes through a cube. It may be meant as a hole, so the result is reported as not
/// faithful, whichever face is first.
void TestRepair::insideOutParts_areNotTakenAway()
{
    TriangleMesh beam = shapes::cube(40);
    for (Vec3f& p : beam.points)
        p = p.cwiseProduct(Vec3f(3, 0.5f, 0.5f)) + Vec3f(5, 0, 0);
    const TriangleMesh cube = shapes::cube(40);
    const double whole = volumeOf(*repairMesh(shapes::together(cube, beam)).mesh);
    TriangleMesh turned = shapes::reversed(beam);
    for (std::size_t first = 0; first < turned.triangles.size(); ++first) {
        std::ranges::rotate(turned.triangles, turned.triangles.begin() + 1);
        for (const TriangleMesh& mesh : {shapes::together(cube, turned), shapes::together(turned, cube)}) {
            const RepairResult result = repairMesh(mesh);
            QVERIFY(result.mesh && !result.report.isFaithful());
            QVERIFY(std::abs(volumeOf(*result.mesh) - whole) < 1e-3 * whole);
        }
    }
}

/// Holes of a plate that extend beyond it may be filled or kept, but filling must be reported.
void TestRepair::filledHoles_areTold()
{
    const auto block = [](float side, float from, float to) {
        TriangleMesh mesh = shapes::cube(2);
        for (Vec3f& p : mesh.points)
            p = {p.x() * side / 2, p.y() < 0 ? from : to, p.z() * side / 2};
        return mesh;
    };
    struct Hole
    {
        float side, from, to;
    };
    const TriangleMesh plate = block(60, -5, 5);
    for (const auto& [side, from, to] :
         {Hole{16, -5.1F, 5.1F}, Hole{16, -5.5F, 5.5F}, Hole{16, -6, 6}, Hole{16, -25, 25}, Hole{24, 4, 6},
          Hole{30, 4.3F, 6.3F}, Hole{34, 4.45F, 11}, Hole{50, 3, 30}, Hole{50, 3, 300}, Hole{6, -600, 600}})
        for (const bool isOpen : {false, true})
            // a distant part enlarges the bounding box, so the hole is a tiny share of it
            for (const float away : {0.0F, 3000.0F}) {
                TriangleMesh mesh = shapes::together(plate, shapes::reversed(block(side, from, to)));
                if (isOpen)
                    mesh.triangles.erase(mesh.triangles.begin());
                if (away > 0)
                    mesh = shapes::together(mesh, shapes::moved(shapes::cube(1), Vec3f::Constant(away)));
                const RepairResult result = repairMesh(mesh);
                QVERIFY(result.mesh);
                const double volume = volumeOf(*result.mesh) - (away > 0 ? 1 : 0);
                const double hole = side * side * (std::min(5.0, double(to)) - std::max(-5.0, double(from)));
                QVERIFY2(std::abs(volume - (36'000 - hole)) < 0.02 * 36'000 || !result.report.isFaithful(),
                         qPrintable(QStringLiteral("%1 wide, %2 to %3, open %4, %5 away: %6")
                                        .arg(side)
                                        .arg(from)
                                        .arg(to)
                                        .arg(isOpen)
                                        .arg(away)
                                        .arg(volume)));
            }
}

/// A part that faces inwards inside a cavity is either inside out or a second cavity, so a large one must be reported.
void TestRepair::partsInHollows_areTold()
{
    const TriangleMesh shell = shapes::together(shapes::cube(40), shapes::reversed(shapes::cube(30)));
    for (const float side : {6.0F, 15.0F, 29.0F}) {
        const RepairResult result = repairMesh(shapes::together(shell, shapes::reversed(shapes::cube(side))));
        QVERIFY(result.mesh);
        const double share = std::pow(double(side), 3) / (40 * 40 * 40 - 30 * 30 * 30);
        QCOMPARE(result.report.isFaithful(), share < RepairReport::maxOtherSpace);
    }
}

/// The inner one of two nested cutters of a blind hole is reversed, or kept as a cavity with innerAreCavities.
void TestRepair::cutterInACutter_isCounted()
{
    const auto cutter = [](float side, float top) {
        TriangleMesh mesh = shapes::cube(side);
        for (Vec3f& p : mesh.points)
            p.y() = p.y() < 0 ? -10 : top;
        return shapes::reversed(mesh);
    };
    const TriangleMesh mesh = shapes::together(shapes::cube(40), shapes::together(cutter(20, 22), cutter(16, 21)));
    for (const bool areHollow : {false, true}) {
        const RepairResult result = repairMesh(mesh, {.innerAreCavities = areHollow});
        QVERIFY(result.mesh);
        QCOMPARE(result.report.innerParts, std::size_t(1));
        QCOMPARE(result.report.turnedFaces, std::size_t(areHollow ? 0 : 1));
        QCOMPARE(volumeOf(*result.mesh) < 40 * 40 * 40 - 0.99 * 20 * 20 * 30, areHollow);
    }
}

/// A tower on a broad open ground is flat relative to its area, but must not be removed as a sheet without a report.
void TestRepair::broadGround_isNotLostSilently()
{
    TriangleMesh ground = shapes::cube(40);
    std::erase_if(ground.triangles, [&](const Triangle& t) {
        return std::ranges::all_of(t, [&](Slot v) { return ground.points[v].y() == ground.points[0].y(); });
    });
    const float y = ground.points[0].y();
    std::vector<Slot> corners;
    for (Slot v = 0; v < 8; ++v)
        if (ground.points[v].y() == y)
            corners.push_back(v);
    QCOMPARE(corners.size(), std::size_t(4));
    const Vec3f middle = (ground.points[corners[0]] + ground.points[corners[1]] + ground.points[corners[2]] +
                          ground.points[corners[3]]) /
                         4;
    std::ranges::sort(corners, {}, [&](Slot v) {
        return std::atan2(ground.points[v].z() - middle.z(), ground.points[v].x() - middle.x());
    });
    for (std::size_t i = 0; i < 4; ++i)
        ground.points.push_back(middle + 10 * (ground.points[corners[i]] - middle));
    for (Slot i = 0; i < 4; ++i) {
        const Slot a = corners[i], b = corners[(i + 1) % 4], c = 8 + i, d = 8 + (i + 1) % 4;
        ground.triangles.push_back({a, c, d});
        ground.triangles.push_back({a, d, b});
    }
    const TriangleMesh bead = shapes::moved(shapes::cube(10), {0, 300, 0});
    const RepairResult result = repairMesh(shapes::together(ground, bead));
    QVERIFY(!result.mesh || !result.report.isFaithful() || volumeOf(*result.mesh) > 64000);
}

/// Boxes around a void share faces, and those of a checkerboard share edges. The space between them must stay empty.
void TestRepair::voidsBetweenParts_stay()
{
    const auto boxes = [](int side, auto isThere) {
        TriangleMesh mesh;
        for (int i = 0; i < side * side * side; ++i) {
            const int x = i % side, y = i / side % side, z = i / side / side;
            if (isThere(x, y, z))
                mesh = shapes::together(
                    mesh, shapes::moved(shapes::cube(10), {10.f * float(x), 10.f * float(y), 10.f * float(z)}));
        }
        return mesh;
    };
    const auto isInner = [](int i) { return i == 1 || i == 2; };
    const RepairResult hollow =
        repairMesh(boxes(4, [&](int x, int y, int z) { return !isInner(x) || !isInner(y) || !isInner(z); }));
    QVERIFY(hollow.mesh && hollow.report.isFaithful());
    QVERIFY(std::abs(volumeOf(*hollow.mesh) - 56'000) < 56);
    const RepairResult board = repairMesh(boxes(4, [](int x, int y, int z) { return (x + y + z) % 2 == 0; }));
    QVERIFY(board.mesh && board.report.isFaithful());
    QVERIFY2(std::abs(volumeOf(*board.mesh) / 32'000 - 1) < 0.02, qPrintable(QString::number(volumeOf(*board.mesh))));
}

void TestRepair::lossOfVolume_isNotFaithful()
{
    RepairReport report;
    report.size = 100;
    report.before.volume = 1000;
    for (const auto& [volume, lost, isFaithful] :
         {std::tuple(1000., 0., true), std::tuple(981., 0.49, true), std::tuple(979., 0., false),
          std::tuple(1021., 0., false), std::tuple(1000., 0.51, false)}) {
        report.after.volume = volume;
        report.lost = lost;
        QCOMPARE(report.isFaithful(), isFaithful);
    }
    report.remeshedAt = 1;
    report.lost = 0;
    report.after.volume = 1000;
    QVERIFY(!report.isFaithful());
}

/// Balls with many faces missing, and a Moebius strip, would enclose a different volume. Such results must not count as
/// faithful.
void TestRepair::otherSpace_isNotFaithful()
{
    StrokeFuzzer random(5);
    for (const double missing : {0.3, 0.4, 0.5}) {
        TriangleMesh ball = icosphere(4, 10);
        std::erase_if(ball.triangles, [&](const Triangle&) { return random.uniform(0, 1) < missing; });
        const RepairResult result = repairMesh(ball);
        const double volume = result.mesh ? volumeOf(*result.mesh) / (4.0 / 3 * std::numbers::pi * 1000) : 0;
        const bool isWhole = volume > 0.97 && volume < 1.03;
        QVERIFY2(!result.mesh || isWhole || !result.report.isFaithful(),
                 qPrintable(QStringLiteral("%1 of the faces missing: %2").arg(missing).arg(volume)));
    }
    TriangleMesh moebius;
    constexpr Slot steps = 60;
    for (Slot i = 0; i < steps; ++i) {
        const double angle = 2 * std::numbers::pi * i / steps;
        for (const double side : {-3.0, 3.0}) {
            const double radius = 10 + side * std::cos(angle / 2);
            moebius.points.push_back(
                Vec3(radius * std::cos(angle), radius * std::sin(angle), side * std::sin(angle / 2)).cast<float>());
        }
        const Slot low = 2 * i, high = low + 1;
        const Slot nextLow = i + 1 == steps ? 1 : low + 2, nextHigh = i + 1 == steps ? 0 : low + 3;
        moebius.triangles.push_back({low, nextLow, nextHigh});
        moebius.triangles.push_back({low, nextHigh, high});
    }
    const RepairResult band = repairMesh(moebius);
    QVERIFY(!band.mesh || !band.report.isFaithful());
}

/// Filling one missing end is intended, so a ball without its cap is repaired faithfully.
void TestRepair::openEnds_areFaithful()
{
    for (const float cut : {-5.0F, 0.0F, 5.0F, 9.0F}) {
        TriangleMesh ball = icosphere(4, 10);
        std::erase_if(ball.triangles, [&](const Triangle& t) {
            return std::ranges::any_of(t, [&](Slot v) { return ball.points[v].y() > cut; });
        });
        const RepairResult result = repairMesh(ball);
        QVERIFY(result.mesh);
        QVERIFY2(result.report.isFaithful(), qPrintable(QStringLiteral("cut at %1: %2 lost, %3 gained")
                                                            .arg(cut)
                                                            .arg(result.report.space.lost)
                                                            .arg(result.report.space.gained)));
    }
}

void TestRepair::farModel_isMovedAndSaid()
{
    const RepairResult result =
        repairMesh(shapes::moved(badModel(QStringLiteral("crossing cubes")).mesh, {4000, 0, 0}));
    QVERIFY(result.mesh);
    QVERIFY(result.report.moved.x() < -3900);
    QVERIFY(result.report.fromNew.largest < 0.01);
}

void TestRepair::threads_doNotChangeTheOutcome()
{
    for (const char* name : {"winding torus knot", "soup"}) {
        std::vector<std::uint64_t> hashes;
        for (const std::size_t threads : {std::size_t(1), std::size_t(4)}) {
            WorkerPool::shared().setThreads(threads);
            hashes.push_back(hashOf(*repairMesh(badModel(QLatin1String(name)).mesh, {.canWrap = true}).mesh));
        }
        WorkerPool::shared().setThreads(0);
        QCOMPARE(hashes[0], hashes[1]);
    }
}

void TestRepair::stopped_hasNoMesh()
{
    std::stop_source stop;
    double last = 0;
    const RepairResult result =
        repairMesh(badModel(QStringLiteral("winding torus knot")).mesh, {}, {stop.get_token(), [&](double share) {
                                                                                 QVERIFY(share >= last);
                                                                                 last = share;
                                                                                 if (share > 0.1)
                                                                                     stop.request_stop();
                                                                             }});
    QVERIFY(last > 0.1);
    QVERIFY(!result.mesh);
}

void TestRepair::strangeModels_becomeSolidsOrAreRefused()
{
    const auto first = static_cast<unsigned>(numberFromEnvironment("FETTLE_SEED", 1));
    const auto count = static_cast<unsigned>(numberFromEnvironment("FETTLE_MODELS", byEffort(12, 40, 20'000)));
    for (unsigned seed = first; seed < first + count; ++seed) {
        const TriangleMesh mesh = strangeModel(seed);
        const RepairResult result = repairMesh(mesh);
        if (!result.mesh) {
            // every kind except loose triangles encloses a volume
            QVERIFY2(seed % 4 == 0, qPrintable(QString::number(seed)));
            continue;
        }
        const auto verdict = judgedByCgal(*result.mesh);
        QVERIFY2(verdict && verdict->allWell(), qPrintable(QString::number(seed)));
        QVERIFY2(buildMesh(*result.mesh).mesh, qPrintable(QString::number(seed)));
    }
}

FETTLE_TEST(TestRepair)
#include "tst_repair.moc"
