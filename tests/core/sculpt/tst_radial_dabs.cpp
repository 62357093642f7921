// Tests radial strokes about y. Sectors related by half and quarter turns must be equal bit for bit, others as far as
// the lattice allows. Every result must be a valid solid.
#include "core/sculpt/deform/deform.h"
#include "core/sculpt/sculptor.h"
#include "core/stroke/radial_symmetry.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <numbers>

using core::DabOutcome;
using core::DabReport;
using core::Mesh;
using core::Sculptor;
using core::Slot;
using core::StrokeSettings;
using core::Symmetry;
using core::Tool;
using core::Turn;
using core::Vec3;
using mesh_asserts::isSound;

namespace
{
using clay::ballRadius;
using std::numbers::pi;

/// Returns a ball of 100 mm, subdivided from an octahedron, so that quarter turns about y map it to itself.
core::TriangleMesh octasphere(int subdivisions)
{
    core::TriangleMesh mesh;
    mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (Slot top : {2u, 3u}) {
        const std::array<Slot, 4> around = top == 2 ? std::array<Slot, 4>{0, 5, 1, 4} : std::array<Slot, 4>{0, 4, 1, 5};
        for (std::size_t i = 0; i < 4; ++i)
            mesh.triangles.push_back({around[i], around[(i + 1) % 4], top});
    }
    for (int level = 0; level < subdivisions; ++level) {
        std::map<std::pair<Slot, Slot>, Slot> middles;
        const auto middle = [&](Slot a, Slot b) {
            const auto [known, isNew] = middles.emplace(std::minmax(a, b), static_cast<Slot>(mesh.points.size()));
            if (isNew)
                mesh.points.push_back(0.5f * (mesh.points[a] + mesh.points[b]));
            return known->second;
        };
        std::vector<core::Triangle> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Slot ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    // computes with |x| and |z| in a fixed order, so that images have the same bits
    for (core::Vec3f& p : mesh.points) {
        const float x = std::max(std::abs(p.x()), std::abs(p.z())), z = std::min(std::abs(p.x()), std::abs(p.z()));
        p *= float(ballRadius) / std::sqrt(x * x + z * z + p.y() * p.y());
    }
    return mesh;
}

std::unique_ptr<Sculptor> octaball(int subdivisions = 5)
{
    return std::make_unique<Sculptor>(mesh_asserts::sculptable(octasphere(subdivisions)));
}

StrokeSettings radialSettings(Tool tool, int radial, Symmetry symmetry = Symmetry::None)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = 8;
    settings.radial = radial;
    settings.symmetry = symmetry;
    settings.color = {30, 60, 200};
    return settings;
}

std::vector<DabReport> radialStroke(Sculptor& sculptor, const StrokeSettings& settings, const std::vector<Vec3>& path,
                                    core::MeshDelta* delta = nullptr)
{
    std::vector<DabReport> reports;
    sculptor.beginStroke(settings);
    for (const Vec3& at : path) {
        core::StrokeSample sample;
        sample.position = at;
        const std::vector<DabReport> more = sculptor.addSample(sample);
        reports.insert(reports.end(), more.begin(), more.end());
    }
    core::MeshDelta end = sculptor.endStroke();
    if (delta)
        *delta = std::move(end);
    return reports;
}

Vec3 onBall(double longitude, double latitude)
{
    const double l = longitude * pi / 180, b = latitude * pi / 180;
    return ballRadius * Vec3(std::sin(l) * std::cos(b), std::sin(b), std::cos(l) * std::cos(b));
}

/// Returns a path between the planes x = 0 and x = z, away from both.
std::vector<Vec3> path()
{
    std::vector<Vec3> path;
    for (int i = 0; i < 5; ++i)
        path.push_back((1 + 0.01 * i) * onBall(20 + 1.5 * i, 4 * i));
    return path;
}

/// Returns the largest distance from the origin of vertices at most `within` from the ray from the origin through `at`.
double heightAlong(const Mesh& mesh, const Vec3& at, double within = 3)
{
    double most = 0;
    const Vec3 way = at.normalized();
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        const Vec3 p = mesh.isVertex(v) ? Vec3(mesh.point(v).cast<double>()) : Vec3::Zero();
        if (const double along = p.dot(way); (p - along * way).norm() <= within)
            most = std::max(most, along);
    }
    return most;
}

Vec3 inSector(int k, int n, const Vec3& p)
{
    return Turn::part(k, n) * p;
}

/// Adds all tools, each with one of the four arrangements in turn, or with all of them.
void addTools()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<int>("radial");
    QTest::addColumn<Symmetry>("plane");
    const std::size_t count = 4, step = byEffort(count, std::size_t(1));
    for (std::size_t i = 0; i < core::toolNames().size(); ++i) {
        for (std::size_t k = i % step; k < count; k += step) {
            const int radial = k % 2 == 0 ? 2 : 4;
            const Symmetry plane = k < 2 ? Symmetry::None : Symmetry::X;
            QTest::addRow("%s, %d, %s", core::toolNames()[i].data(), radial, core::name(plane).data())
                << static_cast<Tool>(i) << radial << plane;
        }
    }
}
} // namespace

class TestRadialDabs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turns_areExactByQuarters();
    void exact_data() { addTools(); }
    void exact();
    void exactTwofold_onTheStarterBall();
    void sixfold_isExactByHalfTurns();
    void everySector_getsItsDab_data();
    void everySector_getsItsDab();
    void everyTool_staysSound_data();
    void everyTool_staysSound();
    void withAPlane_eachSectorIsMirrored();
    void onTheAxis_isOneDab_data();
    void onTheAxis_isOneDab();
    void besideTheAxis_staysSound_data();
    void besideTheAxis_staysSound();
    void noisyModel_isDoneOneAfterTheOther();
    void paintedModel_keepsItsColours();
    void heldClay_isHeldInEachSector_data();
    void heldClay_isHeldInEachSector();
    void heldHalf_staysOne_data();
    void heldHalf_staysOne();
    void spheres_areAddedInEachSector();
    void hook_seesSoundMeshes();
    void undone_data() { addTools(); }
    void undone();
    void footprint_hasAllSectors();
    void unusableCount_isAnEmptyDab();
};

void TestRadialDabs::turns_areExactByQuarters()
{
    const Vec3 p(3, 5, 7);
    QCOMPARE(inSector(1, 4, p), Vec3(7, 5, -3));
    QCOMPARE(inSector(1, 2, p), Vec3(-3, 5, -7));
    QCOMPARE(inSector(6, 8, p), Vec3(-7, 5, 3));
    for (int n = 1; n <= core::maxRadial; ++n) {
        for (int k = 0; k < n; ++k) {
            const Turn turn = Turn::part(k, n);
            QVERIFY(std::abs(turn.cosine - std::cos(2 * pi * k / n)) < 4e-15 &&
                    std::abs(turn.sine - std::sin(2 * pi * k / n)) < 4e-15);
        }
    }
}

/// Tests undo and redo as well: each must restore the same bits.
void TestRadialDabs::exact()
{
    QFETCH(Tool, tool);
    QFETCH(int, radial);
    QFETCH(Symmetry, plane);
    const auto sculptor = octaball();
    QCOMPARE(mirror_asserts::turnedAsymmetry(sculptor->mesh(), 4), std::string());
    const std::uint64_t start = sculptor->mesh().stateHash();
    const StrokeSettings settings = radialSettings(tool, radial, plane);
    core::MeshDelta delta;
    for (const DabReport& report : radialStroke(*sculptor, settings, path(), &delta))
        QVERIFY(!report.sequential && !report.asymmetric && report.outcome != DabOutcome::Empty);
    QVERIFY(!delta.empty());
    QCOMPARE(mirror_asserts::turnedAsymmetry(sculptor->mesh(), radial), std::string());
    if (plane != Symmetry::None)
        VERIFY_SYMMETRIC(sculptor->mesh(), plane);
    QVERIFY(isSound(*sculptor));
    const std::uint64_t end = sculptor->mesh().stateHash();
    sculptor->swap(delta);
    QCOMPARE(sculptor->mesh().stateHash(), start);
    radialStroke(*sculptor, settings, path());
    QCOMPARE(sculptor->mesh().stateHash(), end);
}

/// Each tool makes a stroke across the results of earlier tools.
void TestRadialDabs::exactTwofold_onTheStarterBall()
{
    Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(5, ballRadius)));
    QCOMPARE(mirror_asserts::turnedAsymmetry(sculptor.mesh(), 2), std::string());
    for (std::size_t tool = 0; tool < core::toolNames().size(); ++tool) {
        for (const DabReport& report : radialStroke(sculptor, radialSettings(static_cast<Tool>(tool), 2), path()))
            QVERIFY(!report.sequential);
        QCOMPARE(mirror_asserts::turnedAsymmetry(sculptor.mesh(), 2), std::string());
    }
    QVERIFY(isSound(sculptor));
}

void TestRadialDabs::sixfold_isExactByHalfTurns()
{
    const auto sculptor = octaball();
    for (const DabReport& report : radialStroke(*sculptor, radialSettings(Tool::Crease, 6), path()))
        QVERIFY(!report.sequential); // sequential dabs would be allowed with six sectors, but none is needed
    QCOMPARE(mirror_asserts::turnedAsymmetry(sculptor->mesh(), 2), std::string());
    QVERIFY(isSound(*sculptor));
}

void TestRadialDabs::everySector_getsItsDab_data()
{
    QTest::addColumn<int>("radial");
    for (const int radial : {2, 3, 4, 5, 6, 7, 12})
        QTest::addRow("%d", radial) << radial;
}

void TestRadialDabs::everySector_getsItsDab()
{
    QFETCH(int, radial);
    const auto sculptor = octaball();
    const Vec3 at = onBall(20, 10);
    radialStroke(*sculptor, radialSettings(Tool::Pull, radial), {at, at, at});
    const double first = heightAlong(sculptor->mesh(), at) - ballRadius;
    QVERIFY(first > 1.5);
    for (int k = 1; k < radial; ++k) {
        const double height = heightAlong(sculptor->mesh(), inSector(k, radial, at)) - ballRadius;
        QVERIFY2(std::abs(height - first) < 0.04 * first,
                 qPrintable(QStringLiteral("%1 and %2").arg(height).arg(first)));
    }
    QVERIFY(std::abs(heightAlong(sculptor->mesh(), onBall(20 + 180.0 / radial, 10)) - ballRadius) < 0.1 || radial > 6);
    QVERIFY(isSound(*sculptor));
}

void TestRadialDabs::everyTool_staysSound_data()
{
    QTest::addColumn<Tool>("tool");
    for (std::size_t i = 0; i < core::toolNames().size(); ++i)
        QTest::newRow(core::toolNames()[i].data()) << static_cast<Tool>(i);
}

/// Five sectors overlap near the pole.
void TestRadialDabs::everyTool_staysSound()
{
    QFETCH(Tool, tool);
    const auto sculptor = octaball();
    StrokeSettings settings = radialSettings(tool, 5, Symmetry::Z);
    settings.radius = 12;
    std::vector<Vec3> upwards;
    for (int i = 0; i < 6; ++i)
        upwards.push_back(onBall(20, 55 + 8 * i));
    radialStroke(*sculptor, settings, upwards);
    QVERIFY(isSound(*sculptor));
}

void TestRadialDabs::withAPlane_eachSectorIsMirrored()
{
    const auto sculptor = octaball();
    const Vec3 at = onBall(12, 10);
    radialStroke(*sculptor, radialSettings(Tool::Pull, 6, Symmetry::X), {at, at, at});
    const double first = heightAlong(sculptor->mesh(), at) - ballRadius;
    QVERIFY(first > 1.5);
    for (int k = 0; k < 6; ++k) {
        Vec3 place = inSector(k, 6, at);
        for (int side = 0; side < 2; ++side, place.x() = -place.x()) {
            const double height = heightAlong(sculptor->mesh(), place) - ballRadius;
            QVERIFY2(std::abs(height - first) < 0.1 * first,
                     qPrintable(QStringLiteral("%1 and %2").arg(height).arg(first)));
        }
    }
    QVERIFY(isSound(*sculptor));
}

void TestRadialDabs::onTheAxis_isOneDab_data()
{
    everySector_getsItsDab_data();
}

void TestRadialDabs::onTheAxis_isOneDab()
{
    QFETCH(int, radial);
    const auto once = octaball(), often = octaball(), beside = octaball();
    const Vec3 pole(0, ballRadius, 0);
    radialStroke(*once, radialSettings(Tool::Pull, 1), {pole});
    const std::vector<DabReport> reports = radialStroke(*often, radialSettings(Tool::Pull, radial), {pole});
    QCOMPARE(often->mesh().stateHash(), once->mesh().stateHash());
    // exact sectors are guaranteed only for 2 and 4, where the dab at the pole counts as sequential
    QCOMPARE(reports.at(0).sequential, radial == 2 || radial == 4);
    radialStroke(*beside, radialSettings(Tool::Pull, radial),
                 {pole + Vec3(0.02, 0, 0.01)}); // a dab slightly beside the pole must not add up either
    QVERIFY(std::abs(heightAlong(beside->mesh(), pole) - heightAlong(once->mesh(), pole)) < 0.1);
    QVERIFY(isSound(*often) && isSound(*beside));
}

void TestRadialDabs::besideTheAxis_staysSound_data()
{
    addTools();
}

void TestRadialDabs::besideTheAxis_staysSound()
{
    QFETCH(Tool, tool);
    QFETCH(int, radial);
    QFETCH(Symmetry, plane);
    const auto sculptor = octaball();
    const std::vector<DabReport> reports =
        radialStroke(*sculptor, radialSettings(tool, radial, plane),
                     {onBall(20, 84), onBall(20, 77), onBall(20, 90), onBall(200, 84)});
    QVERIFY(std::ranges::any_of(reports, &DabReport::sequential));
    QVERIFY(isSound(*sculptor));
}

void TestRadialDabs::noisyModel_isDoneOneAfterTheOther()
{
    Sculptor sculptor(mesh_asserts::sculptable(shapes::noisy(octasphere(5), 0.05f, 3)));
    const Vec3 at = onBall(20, 10);
    for (const DabReport& report : radialStroke(sculptor, radialSettings(Tool::Pull, 4), {at, at, at}))
        QVERIFY(report.sequential && report.outcome == DabOutcome::Committed);
    const double first = heightAlong(sculptor.mesh(), at) - ballRadius;
    QVERIFY(first > 1.5);
    for (int k = 1; k < 4; ++k)
        QVERIFY(std::abs(heightAlong(sculptor.mesh(), inSector(k, 4, at)) - ballRadius - first) < 0.1 * first);
    QVERIFY(isSound(sculptor));
}

/// Paint in one sector must not be copied to other sectors.
void TestRadialDabs::paintedModel_keepsItsColours()
{
    const auto sculptor = octaball();
    StrokeSettings red = radialSettings(Tool::Paint, 1);
    red.color = {255, 0, 0};
    red.falloff = 0;
    red.radius = 16;
    radialStroke(*sculptor, red, {onBall(20, 10)});
    const auto reds = [&] {
        int sectors = 0;
        const Mesh& mesh = sculptor->mesh();
        for (int k = 0; k < 4; ++k) {
            const auto isRed = [&](Slot v) {
                return mesh.isVertex(v) && mesh.color(v).g < 100 &&
                       (inSector(k, 4, onBall(20, 10)) - mesh.point(v).cast<double>()).norm() < 12;
            };
            bool has = false;
            for (Slot v = 0; v < mesh.slots().vertices; ++v)
                has = has || isRed(v);
            sectors += has ? 1 : 0;
        }
        return sectors;
    };
    QCOMPARE(reds(), 1);
    for (const DabReport& report : radialStroke(*sculptor, radialSettings(Tool::Inflate, 4), path()))
        QVERIFY(report.sequential);
    QCOMPARE(reds(), 1);
    QVERIFY(isSound(*sculptor));
}

void TestRadialDabs::heldClay_isHeldInEachSector_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<Symmetry>("plane");
    QTest::addColumn<bool>("meets");
    for (const Tool tool : {Tool::Grab, Tool::SnakeHook}) {
        for (const Symmetry plane : {Symmetry::None, Symmetry::X}) {
            for (const bool meets : {false, true}) {
                if (tool == Tool::Grab || !meets)
                    QTest::addRow("%s, %s, %s", core::name(tool).data(), core::name(plane).data(),
                                  meets ? "meets" : "alone")
                        << tool << plane << meets;
            }
        }
    }
}

/// Drags clay outwards in each sector, in some rows against a ball in one sector. From contact on, each sector moves by
/// itself. All reach the same height except the blocked one and, with a mirror plane, its image.
void TestRadialDabs::heldClay_isHeldInEachSector()
{
    QFETCH(Tool, tool);
    QFETCH(Symmetry, plane);
    QFETCH(bool, meets);
    const auto sculptor = octaball();
    const Vec3 at = onBall(22, 0);
    if (meets) {
        StrokeSettings obstacle = radialSettings(Tool::Pull, 1);
        obstacle.add = true;
        QVERIFY(radialStroke(*sculptor, obstacle, {inSector(1, 4, 1.44 * at)}).at(0).outcome == DabOutcome::Added);
    }
    StrokeSettings settings = radialSettings(tool, 4, plane);
    settings.fusion = false;
    std::vector<Vec3> way;
    for (int i = 0; i < 12; ++i)
        way.push_back((1 + 0.04 * i) * at);
    const std::vector<DabReport> reports = radialStroke(*sculptor, settings, way);
    QVERIFY(!reports[1].sequential && !reports[2].sequential);
    QCOMPARE(reports.back().sequential, meets);
    const double first = heightAlong(sculptor->mesh(), at) - ballRadius;
    QVERIFY(first > 0.8 * 22);
    const Vec3 stop = inSector(1, 4, at);
    for (int k = 0; k < 4; ++k) {
        Vec3 place = inSector(k, 4, at);
        for (int side = 0; side < (plane == Symmetry::None ? 1 : 2); ++side, place.x() = -place.x()) {
            const double height = heightAlong(sculptor->mesh(), place) - ballRadius;
            const bool isBlocked =
                meets && std::abs(std::abs(place.x()) - std::abs(stop.x())) + std::abs(place.z() - stop.z()) < 1;
            QVERIFY2((std::abs(height - first) < 0.06 * first) != isBlocked,
                     qPrintable(QStringLiteral("%1 and %2").arg(height).arg(first)));
        }
    }
    QVERIFY(isSound(*sculptor));
}

void TestRadialDabs::heldHalf_staysOne_data()
{
    QTest::addColumn<Symmetry>("plane");
    QTest::addColumn<int>("sectors");
    for (const int sectors : {2, 4}) {
        for (const Symmetry plane : {Symmetry::X, Symmetry::Y, Symmetry::Z})
            QTest::addRow("%s, %d sectors", core::name(plane).data(), sectors) << plane << sectors;
    }
}

/// Balls on both sides of the mirror plane block another sector. Its two halves continue by themselves, but must remain
/// exact mirror images.
void TestRadialDabs::heldHalf_staysOne()
{
    QFETCH(Symmetry, plane);
    QFETCH(int, sectors);
    const auto sculptor = octaball();
    const Vec3 at = onBall(22, 30);
    StrokeSettings obstacle = radialSettings(Tool::Pull, 1, plane);
    obstacle.add = true;
    QVERIFY(radialStroke(*sculptor, obstacle, {inSector(1, sectors, 1.44 * at)}).at(0).outcome == DabOutcome::Added);
    VERIFY_SYMMETRIC(sculptor->mesh(), plane);

    StrokeSettings settings = radialSettings(Tool::Grab, sectors, plane);
    settings.fusion = false;
    std::vector<Vec3> way;
    for (int i = 0; i < 12; ++i)
        way.push_back((1 + 0.04 * i) * at);
    const std::vector<DabReport> reports = radialStroke(*sculptor, settings, way);
    QVERIFY(!reports[1].sequential && reports.back().sequential);
    for (const DabReport& report : reports)
        QVERIFY(!report.asymmetric);
    VERIFY_SYMMETRIC(sculptor->mesh(), plane);
    QVERIFY(heightAlong(sculptor->mesh(), at) - ballRadius > 0.8 * 22);
    QVERIFY(isSound(*sculptor));
}

void TestRadialDabs::spheres_areAddedInEachSector()
{
    for (const int radial : {3, 4}) {
        const auto sculptor = octaball(3);
        StrokeSettings settings = radialSettings(Tool::Pull, radial);
        settings.add = true;
        const std::vector<DabReport> reports = radialStroke(*sculptor, settings, {1.5 * onBall(20, 10)});
        QVERIFY(reports.at(0).outcome == DabOutcome::Added);
        QCOMPARE(mesh_asserts::eulerNumber(sculptor->mesh()), 2 * (radial + 1));
        QVERIFY(isSound(*sculptor));
        if (radial == 4)
            QCOMPARE(mirror_asserts::turnedAsymmetry(sculptor->mesh(), 4), std::string());
        const std::vector<DabReport> more =
            radialStroke(*sculptor, settings, {Vec3(4, 70, 0)}); // spheres in different sectors would overlap
        QVERIFY(more.at(0).outcome == DabOutcome::Refused && more.at(0).refusal == core::Refusal::TooClose);
        QVERIFY(isSound(*sculptor));
    }
}

void TestRadialDabs::hook_seesSoundMeshes()
{
    const auto sculptor = octaball(4);
    int calls = 0;
    std::string broken;
    sculptor->setBetweenSubsteps([&] {
        ++calls;
        if (broken.empty())
            broken = mesh_asserts::brokenLinks(sculptor->mesh());
        if (broken.empty() && !mesh_asserts::badFaces(sculptor->mesh()).empty())
            broken = "faces meet";
    });
    StrokeSettings settings = radialSettings(Tool::Pull, 4);
    settings.strength = 4;
    radialStroke(*sculptor, settings, {onBall(20, 10), onBall(20, 76)});
    QVERIFY(calls >= 8);
    QCOMPARE(broken, std::string());
}

/// hash(A, undo, B) = hash(B): an undone stroke leaves no state of held or raised clay in any sector.
void TestRadialDabs::undone()
{
    QFETCH(Tool, tool);
    QFETCH(int, radial);
    QFETCH(Symmetry, plane);
    const auto used = octaball(4), fresh = octaball(4);
    const StrokeSettings settings = radialSettings(tool, radial, plane);
    core::MeshDelta delta;
    radialStroke(*used, settings, {onBall(20, 70), onBall(25, 60), onBall(30, 50)}, &delta);
    used->swap(delta);
    QCOMPARE(used->mesh().stateHash(), fresh->mesh().stateHash());
    for (Sculptor* sculptor : {used.get(), fresh.get()})
        radialStroke(*sculptor, settings, path());
    QCOMPARE(used->mesh().stateHash(), fresh->mesh().stateHash());
}

void TestRadialDabs::footprint_hasAllSectors()
{
    const auto sculptor = octaball(4);
    const std::size_t one = sculptor->footprint(radialSettings(Tool::Pull, 1), onBall(20, 10)).slots.size();
    QVERIFY(one > 5);
    QCOMPARE(sculptor->footprint(radialSettings(Tool::Pull, 4), onBall(20, 10)).slots.size(), 4 * one);
    QCOMPARE(sculptor->footprint(radialSettings(Tool::Pull, 4, Symmetry::X), onBall(20, 10)).slots.size(), 8 * one);
}

void TestRadialDabs::unusableCount_isAnEmptyDab()
{
    const auto sculptor = octaball(3);
    const std::uint64_t before = sculptor->mesh().stateHash();
    for (const int radial : {0, -1, core::maxRadial + 1})
        QVERIFY(radialStroke(*sculptor, radialSettings(Tool::Pull, radial), {onBall(20, 10)}).at(0).outcome ==
                DabOutcome::Empty);
    QCOMPARE(sculptor->mesh().stateHash(), before);
}

FETTLE_TEST(TestRadialDabs, QCoreApplication)
#include "tst_radial_dabs.moc"
