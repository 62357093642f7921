// Tests the print check (walls, overhangs, bases) on solids of known dimensions.

#include "core/primitives/starter_models.h"
#include "core/print/print_check.h"
#include "core/util/worker_pool.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using core::PrintLimits;
using core::PrintMeasures;
using core::PrintPicture;
using core::PrintReport;
using core::Slot;
using core::TriangleMesh;
using core::Vec3;
using core::Vec3f;

class TestPrintCheck : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void walls_areAsThickAsTheyWereMade_data();
    void walls_areAsThickAsTheyWereMade();
    void edges_ofRightAnglesAreNotThin();
    void edges_ofKnivesAre();
    void balls_areEmpty_data();
    void balls_areEmpty();
    void walls_doNotDependOnThreads();
    void thin_isNeverMoreThanAll_data();
    void thin_isNeverMoreThanAll();
    void thin_placesAreFoundApart();
    void overhangs_areThoseThatLeanOut();
    void overhangs_ofABall();
    void overhangs_ofExactlyTheLimitAreNone();
    void base_isWhatLiesOnTheBed();
    void bed_holdsWhatFits();
    void broken_modelsHaveNoWalls();
    void picture_showsWhatWasMeasured();
    void units_areDoubtedBySize();
    void stopped_endsSoon();
};

namespace
{
PrintMeasures measured(const TriangleMesh& mesh)
{
    return core::measureForPrint(mesh);
}

Vec3 normalOf(const TriangleMesh& mesh, std::size_t face)
{
    const auto& [a, b, c] = mesh.triangles[face];
    const Vec3 p = mesh.points[a].cast<double>();
    return (mesh.points[b].cast<double>() - p).cross(mesh.points[c].cast<double>() - p);
}

Vec3 centreOf(const TriangleMesh& mesh, std::size_t face)
{
    Vec3 sum = Vec3::Zero();
    for (const Slot corner : mesh.triangles[face])
        sum += mesh.points[corner].cast<double>();
    return sum / 3;
}

TriangleMesh turnedAboutZ(TriangleMesh mesh, double degrees)
{
    const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
    for (Vec3f& p : mesh.points) {
        const Vec3 q = p.cast<double>();
        p = Vec3(c * q.x() - s * q.y(), s * q.x() + c * q.y(), q.z()).cast<float>();
    }
    return mesh;
}

/// Returns the profile with points inserted about 1 mm apart.
std::vector<Vec3> dense(const std::vector<Vec3>& corners)
{
    std::vector<Vec3> profile = {corners.front()};
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Vec3 step = corners[i] - corners[i - 1];
        const int steps = std::max(1, static_cast<int>(step.norm()));
        for (int k = 1; k <= steps; ++k)
            profile.push_back(corners[i - 1] + step * k / steps);
    }
    return profile;
}

/// Returns a vase 60 mm high, with a wall 1.5 mm thick and a floor 3 mm thick.
TriangleMesh vase()
{
    return clay::revolved(dense({{0, 0, 0}, {20, 0, 0}, {20, 60, 0}, {18.5, 60, 0}, {18.5, 3, 0}, {0, 3, 0}}), 96);
}

TriangleMesh shell(double outer, double inner)
{
    return shapes::together(core::icosphere(4, outer), shapes::reversed(core::icosphere(4, inner)));
}

/// Returns a wedge whose edge at x = 0 encloses `degrees`. Its sides are 10 mm long, and it extends along z.
TriangleMesh wedge(double degrees)
{
    const double half = degrees * std::numbers::pi / 360;
    const auto x = static_cast<float>(10 * std::cos(half)), y = static_cast<float>(10 * std::sin(half));
    TriangleMesh mesh{{{0, 0, 0}, {x, -y, 0}, {x, y, 0}, {0, 0, 10}, {x, -y, 10}, {x, y, 10}}, {}, {}};
    mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return mesh;
}

double minOf(const std::vector<float>& values)
{
    return static_cast<double>(*std::ranges::min_element(values));
}
} // namespace

void TestPrintCheck::walls_areAsThickAsTheyWereMade_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<double>("thickness");
    QTest::addColumn<double>("share"); ///< smallest share of the surface that has this thickness
    QTest::addRow("slab") << clay::slab(40, 2, 10) << 2.0 << 0.9;
    QTest::addRow("slab of few triangles") << clay::slab(40, 2, 1) << 2.0 << 0.9;
    QTest::addRow("tilted slab") << turnedAboutZ(clay::slab(40, 2, 10), 33) << 2.0 << 0.9;
    QTest::addRow("shell") << shell(20, 18) << 2.0 << 1.0;
    QTest::addRow("shell, thin") << shell(20, 19.6) << 0.4 << 1.0;
    QTest::addRow("ball") << core::icosphere(4, 10) << 20.0 << 1.0;
    QTest::addRow("torus") << shapes::torus({30, 4, 120, 60}) << 8.0 << 1.0;
    QTest::addRow("vase") << vase() << 1.5 << 0.8;
    QTest::addRow("rod") << clay::tube({{0, 0, 0}, {0, 60, 0}}, 1.5, 32) << 3.0 << 0.9;
}

void TestPrintCheck::walls_areAsThickAsTheyWereMade()
{
    QFETCH(const TriangleMesh, mesh);
    QFETCH(const double, thickness);
    QFETCH(const double, share);
    constexpr double tolerance = 0.06; // relative; facets cut into the ideal round shape
    const PrintMeasures measures = measured(mesh);
    QVERIFY(measures.walls);
    const std::vector<float>& found = measures.walls->atCentres;
    QVERIFY2(std::abs(minOf(found) / thickness - 1) < tolerance, qPrintable(QString::number(minOf(found))));
    double all = 0, soThick = 0;
    for (std::size_t f = 0; f < found.size(); ++f) {
        const double area = normalOf(mesh, f).norm();
        all += area;
        soThick += std::abs(static_cast<double>(found[f]) / thickness - 1) < tolerance ? area : 0;
    }
    QVERIFY2(soThick / all > share - 1e-9, qPrintable(QString::number(soThick / all)));
    const PrintReport report = core::checkForPrint(measures, {.minWall = thickness * (1 + tolerance), .bed = {}});
    QVERIFY(report.thin.area > share * report.area * (1 - 1e-6));
    QCOMPARE(core::checkForPrint(measures, {.minWall = thickness * (1 - tolerance), .bed = {}}).thin.count, 0u);
}

void TestPrintCheck::edges_ofRightAnglesAreNotThin()
{
    for (const TriangleMesh& mesh :
         {shapes::cube(10), turnedAboutZ(shapes::cube(10), 20), shapes::scaled(shapes::tetrahedron(), 10)}) {
        const PrintMeasures measures = measured(mesh);
        QVERIFY(measures.walls);
        QVERIFY(minOf(measures.walls->atCentres) > 5);
    }
}

void TestPrintCheck::edges_ofKnivesAre()
{
    const PrintMeasures measures = measured(wedge(30));
    QVERIFY(measures.walls);
    QVERIFY(minOf(measures.walls->atCentres) < 3);
    QVERIFY(minOf(measures.walls->atCentres) > 0.5);
}

void TestPrintCheck::balls_areEmpty_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addRow("ball") << shapes::noisy(core::icosphere(3, 4.5), 0.02F, 1);
    QTest::addRow("cube") << turnedAboutZ(shapes::cube(7), 12);
    QTest::addRow("wedge") << wedge(40);
    QTest::addRow("lens") << [] {
        TriangleMesh mesh = core::icosphere(3, 10);
        for (Vec3f& p : mesh.points)
            p.y() *= 0.2F;
        return mesh;
    }();
}

/// Checks that no opposite corner or face centre is inside a ball. In a convex solid every pair of points is in sight.
void TestPrintCheck::balls_areEmpty()
{
    QFETCH(const TriangleMesh, mesh);
    const PrintMeasures measures = measured(mesh);
    QVERIFY(measures.walls);
    std::size_t balls = 0;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const auto diameter = static_cast<double>(measures.walls->atCentres[f]);
        if (!std::isfinite(diameter) || diameter > PrintLimits::largestBall)
            continue;
        ++balls;
        const Vec3 normal = normalOf(mesh, f).normalized(), centre = centreOf(mesh, f) - diameter / 2 * normal;
        for (std::size_t g = 0; g < mesh.triangles.size(); ++g) {
            if (normal.dot(normalOf(mesh, g).normalized()) >= -0.5 - 1e-6)
                continue;
            for (const Slot corner : mesh.triangles[g])
                QVERIFY((mesh.points[corner].cast<double>() - centre).norm() > diameter / 2 * 0.9 * (1 - 1e-5));
            QVERIFY((centreOf(mesh, g) - centre).norm() > diameter / 2 * 0.9 * (1 - 1e-5));
        }
    }
    QVERIFY(balls > 0);
}

void TestPrintCheck::walls_doNotDependOnThreads()
{
    const TriangleMesh mesh = core::starterModel(core::Starter::Head);
    core::WorkerPool::shared().setThreads(1);
    const core::WallThickness alone = core::wallThickness(mesh, PrintLimits::largestBall);
    core::WorkerPool::shared().setThreads(5);
    const core::WallThickness together = core::wallThickness(mesh, PrintLimits::largestBall);
    core::WorkerPool::shared().setThreads(0);
    QVERIFY(alone.atCentres == together.atCentres);
}

void TestPrintCheck::thin_isNeverMoreThanAll_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addRow("wedge") << wedge(30);
    QTest::addRow("head") << core::starterModel(core::Starter::Head);
    QTest::addRow("star") << [] { // every third vertex is a spike, so the model is sharp everywhere
        TriangleMesh mesh = core::icosphere(1, 10);
        for (std::size_t i = 0; i < mesh.points.size(); i += 3)
            mesh.points[i] *= 2;
        return mesh;
    }();
}

/// Checks the thin area of models that are thin everywhere, including their sharp edges.
void TestPrintCheck::thin_isNeverMoreThanAll()
{
    QFETCH(TriangleMesh, mesh);
    for (Vec3f& p : mesh.points)
        p *= 0.02F;
    const PrintReport report = core::checkForPrint(measured(mesh), {.minWall = 8, .bed = {}});
    QVERIFY(report.thin.area > 0.9 * report.area);
    QVERIFY(report.thin.area <= report.area);
}

void TestPrintCheck::thin_placesAreFoundApart()
{
    TriangleMesh mesh = shapes::moved(shapes::cube(20), {-10, 0, -10});
    mesh = shapes::together(mesh, shapes::moved(clay::slab(10, 0.5, 3), {40, 0, 0}));
    mesh = shapes::together(mesh, shapes::moved(clay::slab(20, 0.7, 3), {80, 0, 0}));
    const PrintReport report = core::checkForPrint(measured(mesh), {.minWall = 0.8, .bed = {}});
    QCOMPARE(report.thin.count, 4u); // two sides of each of two plates
    QCOMPARE(report.thin.places.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const core::PrintPlace& place = report.thin.places[i];
        QCOMPARE(std::abs(place.point.x() - 80) < 10, i < 2);
        QVERIFY(std::abs(place.worst - (i < 2 ? 0.7 : 0.5)) < 1e-3);
        QVERIFY(std::abs(place.area - (i < 2 ? 400 : 100)) < 0.1);
        QVERIFY(std::abs(std::abs(place.normal.y()) - 1) < 1e-6);
    }
    QVERIFY(std::abs(report.thin.area - 1000) < 0.1);
    QVERIFY(report.thinnest);
    QVERIFY(std::abs(*report.thinnest - 0.5) < 1e-3);
}

void TestPrintCheck::overhangs_areThoseThatLeanOut()
{
    // The model is a table: a plate of 20 x 20 on a cube of 4. The underside of the plate overhangs.
    const TriangleMesh cube = shapes::moved(shapes::cube(4), {-2, 0, -2});
    const TriangleMesh table = shapes::together(cube, shapes::moved(clay::slab(20, 2, 4), {0, 11, 0}));
    const PrintReport report = core::checkForPrint(measured(table), {.bed = {}});
    QCOMPARE(report.overhangs.count, 1u);
    QVERIFY(std::abs(report.overhangs.area - 400) < 1e-3);
    QVERIFY(std::abs(report.overhangs.places[0].worst - 90) < 1e-6);
    QVERIFY(std::abs(report.overhangs.places[0].point.y() - 10) < 1e-5);
}

/// The cap whose normals point more than 45 degrees downwards is (1 - cos 45) / 2 of a ball's surface.
void TestPrintCheck::overhangs_ofABall()
{
    const PrintMeasures ball = measured(core::icosphere(5, 10));
    for (const double limit : {30.0, 45.0, 60.0}) {
        const double angle = (90 - limit) * std::numbers::pi / 180;
        const PrintReport report = core::checkForPrint(ball, {.overhang = limit, .bed = {}});
        QVERIFY(std::abs(report.overhangs.area / report.area - (1 - std::cos(angle)) / 2) < 0.01);
        QCOMPARE(report.overhangs.count, 1u);
    }
    QCOMPARE(core::checkForPrint(ball, {.overhang = 90, .bed = {}}).overhangs.count, 0u);
}

void TestPrintCheck::overhangs_ofExactlyTheLimitAreNone()
{
    // The model is an inverted roof: it rests on an edge, and its walls lean outwards by exactly 45 degrees.
    const TriangleMesh mesh{{{0, 0, 0}, {-8, 8, 0}, {8, 8, 0}, {0, 0, 8}, {-8, 8, 8}, {8, 8, 8}},
                            {},
                            {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};
    const PrintMeasures measures = measured(shapes::reversed(mesh));
    QVERIFY(measures.report.printReady());
    QCOMPARE(core::checkForPrint(measures, {.overhang = 45, .bed = {}}).overhangs.area, 0.0);
    QVERIFY(core::checkForPrint(measures, {.overhang = 44, .bed = {}}).overhangs.area > 100);
}

void TestPrintCheck::base_isWhatLiesOnTheBed()
{
    QCOMPARE(core::checkForPrint(measured(shapes::cube(8)), {.bed = {}}).baseArea, 64.0);
    QCOMPARE(core::checkForPrint(measured(shapes::moved(shapes::cube(8), {0, -96, 0})), {.bed = {}}).baseArea, 64.0);
    QCOMPARE(core::checkForPrint(measured(core::icosphere(4, 10)), {.bed = {}}).baseArea, 0.0);
    QCOMPARE(core::checkForPrint(measured(turnedAboutZ(shapes::cube(8), 1)), {.bed = {}}).baseArea, 0.0);
    const double ring = core::checkForPrint(measured(vase()), {.bed = {}}).baseArea;
    QVERIFY(std::abs(ring / (400 * std::numbers::pi) - 1) < 0.01);
}

void TestPrintCheck::bed_holdsWhatFits()
{
    TriangleMesh box = shapes::cube(1);
    for (Vec3f& p : box.points)
        p = p.cwiseProduct(Vec3f(100, 50, 20));
    const PrintMeasures measures = measured(box);
    const auto fit = [&](const core::PrintBed& bed) { return core::checkForPrint(measures, {.bed = bed}).fit; };
    QVERIFY(fit({100, 20, 50}) == core::BedFit::AsItStands); // the height of a model is along y, that of a bed along z
    QVERIFY(fit({20, 100, 50}) == core::BedFit::Turned);
    QVERIFY(fit({99, 99, 50}) == core::BedFit::Not);
    QVERIFY(fit({200, 200, 49}) == core::BedFit::Not);
    QVERIFY(fit({19, 200, 200}) == core::BedFit::Not);
}

void TestPrintCheck::broken_modelsHaveNoWalls()
{
    for (const TriangleMesh& mesh :
         {shapes::openCone(7), shapes::cubeWithFlippedFace(), shapes::reversed(shapes::cube(3)),
          shapes::sphereThroughSphere(), TriangleMesh()}) {
        const PrintMeasures measures = measured(mesh);
        QVERIFY(!measures.walls);
        const PrintReport report = core::checkForPrint(measures, {.bed = {300, 300, 300}});
        QVERIFY(!report.thinnest);
        QCOMPARE(report.thin.count, 0u);
        QVERIFY(report.fit == core::BedFit::AsItStands);
        QVERIFY(std::ranges::all_of(core::pictureOf(measures, PrintPicture::Thickness),
                                    [](float t) { return std::isinf(t); }));
    }
}

void TestPrintCheck::picture_showsWhatWasMeasured()
{
    const TriangleMesh slab = clay::slab(40, 2, 10);
    const PrintMeasures measures = measured(slab);
    const std::vector<float> thickness = core::pictureOf(measures, PrintPicture::Thickness);
    QCOMPARE(thickness.size(), slab.points.size());
    for (const float value : thickness)
        QVERIFY(std::abs(value - 2) < 1e-3F);
    const std::vector<float> leaning = core::pictureOf(measured(core::icosphere(5, 10)), PrintPicture::Overhang);
    const TriangleMesh ball = core::icosphere(5, 10);
    for (std::size_t v = 0; v < leaning.size(); ++v) {
        const double angle =
            -std::asin(std::clamp(static_cast<double>(ball.points[v].y()) / 10, -1.0, 1.0)) * 180 / std::numbers::pi;
        // the picture shows the steepest face at each vertex
        QVERIFY(std::abs(static_cast<double>(leaning[v]) - angle) < 4 || leaning[v] == -90);
    }
}

void TestPrintCheck::units_areDoubtedBySize()
{
    using core::UnitDoubt;
    QVERIFY(core::unitDoubtOf(8) == UnitDoubt::None);
    QVERIFY(core::unitDoubtOf(7.99) == UnitDoubt::Inches);
    QVERIFY(core::unitDoubtOf(0.001) == UnitDoubt::Inches);
    QVERIFY(core::unitDoubtOf(0.0009) == UnitDoubt::Metres);
    QVERIFY(core::unitDoubtOf(-1e6) == UnitDoubt::None); // a negative volume means inside out, not small
    QVERIFY(core::guessedUnit(7, 4) == UnitDoubt::Inches);
    QVERIFY(core::guessedUnit(0.9, 0.99) == UnitDoubt::Metres);
    // slicers accept this size without doubt, but a user may still doubt the unit
    QVERIFY(core::guessedUnit(300, 19.9) == UnitDoubt::Inches);
    QVERIFY(core::guessedUnit(0.5, 0.99) == UnitDoubt::Metres);
    QVERIFY(core::guessedUnit(8, 20) == UnitDoubt::None);
}

void TestPrintCheck::stopped_endsSoon()
{
    std::stop_source source;
    double last = 0;
    const TriangleMesh mesh = core::icosphere(6, 10);
    const PrintMeasures measures = core::measureForPrint(mesh, {source.get_token(), [&](double share) {
                                                                    QVERIFY(share >= last);
                                                                    last = share;
                                                                    if (share > 0.5)
                                                                        source.request_stop();
                                                                }});
    QVERIFY(last > 0.5 && last < 0.9);
}

FETTLE_TEST(TestPrintCheck, QCoreApplication)

#include "tst_print_check.moc"
