// Tests union and difference with a solid, and the strokes that use them.
#include "core/analysis/mesh_check.h"
#include "core/mesh/mesh_builder.h"
#include "core/primitives/starter_models.h"
#include "core/sculpt/deform/brush_model.h"
#include "core/sculpt/solid_boolean.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using core::BooleanOperation;
using core::DabOutcome;
using core::DabReport;
using core::StrokeSettings;
using core::TriangleMesh;
using core::Vec3;
using mesh_asserts::volumeOf;

namespace
{
TriangleMesh ballAt(const core::Mesh& mesh, const Vec3& center, double radius)
{
    TriangleMesh ball = core::icosphere(3, radius);
    for (core::Vec3f& p : ball.points)
        p = mesh.lattice().snap(p.cast<double>() + center);
    return ball;
}

/// Returns the mesh after the operation, or null if the operation was refused.
std::unique_ptr<core::Mesh> after(BooleanOperation operation, const TriangleMesh& model, const Vec3& center,
                                  double radius)
{
    auto mesh = mesh_asserts::sculptable(model);
    core::VerifiedMesh surface(*mesh);
    const core::SolidBoolean boolean(surface, ballAt(*mesh, center, radius));
    if (!boolean.areCrossing())
        return nullptr;
    const std::optional<core::Surgery> surgery = boolean.surgery(operation);
    mesh->beginStroke();
    const bool isDone =
        surgery && isSurgeryOk(*mesh, *surgery) && surface.tryOperation([&] { mesh->replaceFaces(*surgery); });
    mesh->endStroke();
    return isDone ? std::move(mesh) : nullptr;
}

StrokeSettings joining(double radius)
{
    StrokeSettings settings;
    settings.radius = radius;
    settings.add = settings.join = true;
    settings.topology = core::Topology::Refine;
    return settings;
}
} // namespace

class TestSolidBoolean : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void volumesAddUp_data();
    void volumesAddUp();
    void ballOnTheSurface_joins_data();
    void ballOnTheSurface_joins();
    void ballBetweenTwoParts_joinsThem();
    void ballInside_isRefused();
    void withoutFusion_isRefused();
    void joinedBall_isSymmetric();
    void joinedBall_isUndone();
    void maskedSurface_stays();
    void radialBalls_joinInAllSectors_data();
    void radialBalls_joinInAllSectors();
    void flushCube_joinsOnEverySide();
    void joinedBall_hasTheColorBesideIt();
};

void TestSolidBoolean::volumesAddUp_data()
{
    QTest::addColumn<TriangleMesh>("model");
    QTest::addRow("ball") << core::icosphere(4, 1);
    QTest::addRow("coarse ball") << core::icosphere(1, 1);
    QTest::addRow("slab") << clay::slab(2, 0.3, 5);
    QTest::addRow("bowl") << clay::bowl();
    QTest::addRow("ring") << clay::cutRing(0.3);
}

/// Checks volumes: union of A and B = (A without B) + B.
void TestSolidBoolean::volumesAddUp()
{
    QFETCH(TriangleMesh, model);
    const unsigned seed = 5;
    std::mt19937_64 random(seed);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    int done = 0;
    for (int i = 0; i < 20; ++i) {
        const core::Vec3f& at = model.points[random() % model.points.size()];
        const Vec3 center = at.cast<double>() + Vec3(between(-0.1, 0.1), between(-0.1, 0.1), between(-0.1, 0.1));
        const double radius = between(0.12, 0.6);
        const auto joined = after(BooleanOperation::Unite, model, center, radius);
        const auto cut = after(BooleanOperation::Subtract, model, center, radius);
        // refused because the solids touch on the lattice, in which case applyBoolean() would shift the solid
        if (!joined || !cut)
            continue;
        ++done;
        const double ball = volumeOf(*mesh_asserts::sculptable(core::icosphere(3, radius)));
        const double difference = volumeOf(*joined) - volumeOf(*cut) - ball;
        QVERIFY2(std::abs(difference) < 1e-4 * ball,
                 qPrintable(QStringLiteral("seed %1, ball %2: %3").arg(seed).arg(i).arg(difference / ball)));
        QVERIFY(mesh_asserts::badFaces(*joined).empty() && mesh_asserts::badFaces(*cut).empty());
    }
    QVERIFY2(done >= 15, qPrintable(QString::number(done)));
}

void TestSolidBoolean::ballOnTheSurface_joins_data()
{
    QTest::addColumn<double>("height");
    QTest::addColumn<bool>("isCube");
    for (const double height : {-9.0, -4.0, 0.0, 4.0, 9.0}) {
        QTest::addRow("ball at %g", height) << height << false;
        QTest::addRow("cube at %g", height) << 0.6 * height << true;
    }
}

void TestSolidBoolean::ballOnTheSurface_joins()
{
    QFETCH(double, height);
    QFETCH(bool, isCube);
    const auto sculptor = clay::ball();
    const double before = volumeOf(sculptor->mesh());
    StrokeSettings settings = joining(10);
    if (isCube)
        settings.model = core::BrushModel::of(core::starterModel(core::Starter::Cube), {}).model;
    const DabReport report = clay::dabOnce(*sculptor, settings, {0, 0, clay::ballRadius + height});
    QCOMPARE(report.outcome, DabOutcome::Added);
    const core::MeshReport judged = core::checkMesh(core::extractMesh(sculptor->mesh()));
    QVERIFY(judged.printReady() && judged.genus == 0 && judged.components == 1);
    QVERIFY(judged.volume.value() > before);
    const double solid = isCube ? std::pow(20 / std::sqrt(3.0), 3) : 4 * std::numbers::pi / 3 * 1000;
    QVERIFY(judged.volume.value() < before + 1.01 * solid);
    QVERIFY(sculptor->hit({{0, 0, 200}, -Vec3::UnitZ()})->position.z() >
            clay::ballRadius + height + (isCube ? 0.99 * 10 / std::sqrt(3.0) : 9.9));
    QVERIFY(mesh_asserts::isSound(*sculptor));
}

void TestSolidBoolean::ballBetweenTwoParts_joinsThem()
{
    core::Sculptor sculptor(mesh_asserts::sculptable(clay::twoFingers(0.1)));
    StrokeSettings settings = joining(0.3);
    const Vec3 middle = Vec3(0, 0, 0);
    QCOMPARE(clay::dabOnce(sculptor, settings, middle).outcome, DabOutcome::Added);
    const core::MeshReport judged = core::checkMesh(core::extractMesh(sculptor.mesh()));
    QVERIFY(judged.printReady() && judged.components == 1 && judged.genus == 0);
}

void TestSolidBoolean::ballInside_isRefused()
{
    const auto sculptor = clay::ball();
    const std::uint64_t before = sculptor->mesh().stateHash();
    const DabReport report = clay::dabOnce(*sculptor, joining(10), {0, 3, 5});
    QVERIFY(report.outcome == DabOutcome::Refused && report.refusal == core::Refusal::Inside);
    QCOMPARE(sculptor->mesh().stateHash(), before);
}

void TestSolidBoolean::withoutFusion_isRefused()
{
    const auto sculptor = clay::ball();
    const std::uint64_t before = sculptor->mesh().stateHash();
    StrokeSettings settings = joining(10);
    settings.fusion = false;
    const DabReport report = clay::dabOnce(*sculptor, settings, {0, 0, clay::ballRadius + 4});
    QVERIFY(report.outcome == DabOutcome::Refused && report.refusal == core::Refusal::TooClose);
    QCOMPARE(sculptor->mesh().stateHash(), before);
}

void TestSolidBoolean::joinedBall_isSymmetric()
{
    // the added ball is apart from its mirror image, barely apart, overlaps it (twice), and is identical with it
    for (const double x : {20.0, 7.0, 3.0, 0.5, 0.0}) {
        const auto sculptor = clay::ball();
        StrokeSettings settings = joining(8);
        settings.symmetry = core::Symmetry::X;
        const DabReport report = clay::dabOnce(*sculptor, settings, clay::ballRadius * Vec3(x, 6, 40).normalized());
        QCOMPARE(report.outcome, DabOutcome::Added);
        const core::MeshReport judged = core::checkMesh(core::extractMesh(sculptor->mesh()));
        QVERIFY(judged.printReady() && judged.components == 1 && judged.genus == 0);
        QCOMPARE(report.asymmetric, x < 6 && x > 0);
        if (!report.asymmetric)
            VERIFY_SYMMETRIC(sculptor->mesh(), core::Symmetry::X);
    }
}

void TestSolidBoolean::joinedBall_isUndone()
{
    const auto sculptor = clay::ball();
    const std::uint64_t before = sculptor->mesh().stateHash();
    sculptor->beginStroke(joining(10));
    core::StrokeSample sample;
    sample.position = {0, 0, clay::ballRadius};
    sculptor->addSample(sample);
    core::MeshDelta delta = sculptor->endStroke();
    const std::uint64_t after = sculptor->mesh().stateHash();
    QVERIFY(after != before);
    sculptor->swap(delta);
    QCOMPARE(sculptor->mesh().stateHash(), before);
    sculptor->swap(delta);
    QCOMPARE(sculptor->mesh().stateHash(), after);
}

void TestSolidBoolean::maskedSurface_stays()
{
    const auto sculptor = clay::ball();
    StrokeSettings mask;
    mask.tool = core::Tool::Mask;
    mask.radius = 6;
    clay::dabOnce(*sculptor, mask, {0, 0, clay::ballRadius});
    const std::uint64_t before = sculptor->mesh().stateHash();
    const DabReport refused = clay::dabOnce(*sculptor, joining(10), {4, 0, clay::ballRadius});
    QVERIFY(refused.outcome == DabOutcome::Refused && refused.refusal == core::Refusal::Masked);
    QCOMPARE(sculptor->mesh().stateHash(), before);
    QCOMPARE(clay::dabOnce(*sculptor, joining(10), {0, 30, 40}).outcome, DabOutcome::Added);
}

void TestSolidBoolean::radialBalls_joinInAllSectors_data()
{
    QTest::addColumn<int>("sectors");
    QTest::addColumn<double>("radius");
    for (const int sectors : {2, 3, 4, 6}) {
        QTest::addRow("%d apart", sectors) << sectors << 6.0;
        QTest::addRow("%d meeting each other", sectors) << sectors << 40.0;
    }
}

void TestSolidBoolean::radialBalls_joinInAllSectors()
{
    QFETCH(int, sectors);
    QFETCH(double, radius);
    const auto sculptor = clay::ball(4);
    StrokeSettings settings = joining(radius);
    settings.radial = sectors;
    QCOMPARE(clay::dabOnce(*sculptor, settings, {0, 10, 49}).outcome, DabOutcome::Added);
    const core::MeshReport judged = core::checkMesh(core::extractMesh(sculptor->mesh()));
    QVERIFY(judged.printReady() && judged.components == 1);
    for (int i = 0; i < sectors; ++i) {
        const double angle = 2 * std::numbers::pi * i / sectors;
        const Vec3 out(std::sin(angle), 0, std::cos(angle));
        const auto hit = sculptor->hit({200 * out + Vec3(0, 10, 0), -out});
        QVERIFY(hit && hit->position.dot(out) > 49 + 0.95 * radius);
    }
}

/// Adds a cube that is half inside the model. Four of its sides are coplanar with sides of the model.
void TestSolidBoolean::flushCube_joinsOnEverySide()
{
    const TriangleMesh cube = core::starterModel(core::Starter::Cube);
    core::Box box;
    for (const core::Vec3f& p : cube.points)
        box.extend(p.cast<double>());
    const double half = 0.5 * box.sizes().maxCoeff();
    const Vec3 middle = box.center();
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : byEffort(std::vector{axis == 1 ? -1.0 : 1.0}, std::vector{-1.0, 1.0})) {
            core::Sculptor sculptor(mesh_asserts::sculptable(cube));
            StrokeSettings settings = joining(half * std::sqrt(3.0));
            settings.model = core::BrushModel::of(cube, {}).model;
            const Vec3 center = middle + side * half * Vec3::Unit(axis);
            QCOMPARE(clay::dabOnce(sculptor, settings, center).outcome, DabOutcome::Added);
            const core::MeshReport judged = core::checkMesh(core::extractMesh(sculptor.mesh()));
            QVERIFY(judged.printReady() && judged.components == 1);
            QVERIFY(std::abs(judged.volume.value() / std::pow(2 * half, 3) - 1.5) < 0.01);
        }
    }
}

void TestSolidBoolean::joinedBall_hasTheColorBesideIt()
{
    TriangleMesh model = core::icosphere(4, 50);
    for (const core::Vec3f& p : model.points)
        model.colors.push_back(p.y() > 0 ? core::Rgb{255, 0, 0} : core::Rgb{0, 0, 255});
    core::Sculptor sculptor(mesh_asserts::sculptable(model));
    QCOMPARE(clay::dabOnce(sculptor, joining(12), {0, 0, 50}).outcome, DabOutcome::Added);
    const core::Mesh& mesh = sculptor.mesh();
    for (core::Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (!mesh.isVertex(v) || std::abs(mesh.point(v).y()) < 4)
            continue;
        QCOMPARE(mesh.color(v).r > mesh.color(v).b, mesh.point(v).y() > 0);
    }
}

FETTLE_TEST(TestSolidBoolean)
#include "tst_solid_boolean.moc"
