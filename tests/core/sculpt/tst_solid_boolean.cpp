// Tests the union with a solid and its difference, and what strokes make of them.
#include "core/analysis/mesh_check.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/starter_models.h"
#include "core/sculpt/deform/brush_model.h"
#include "core/sculpt/solid_boolean.h"
#include "tests/support/clay.h"
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

/// Returns the mesh after the operation, or null if that was refused.
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

/// The union of two solids has the volume of their difference and of the second.
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
        if (!joined || !cut) // touches on the lattice: applyBoolean() shifts the solid then
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
    for (const double x : {20.0, 3.0}) { // clear of its image, and meeting it
        const auto sculptor = clay::ball();
        StrokeSettings settings = joining(8);
        settings.symmetry = core::Symmetry::X;
        const DabReport report = clay::dabOnce(*sculptor, settings, clay::ballRadius * Vec3(x, 6, 40).normalized());
        QCOMPARE(report.outcome, DabOutcome::Added);
        const core::MeshReport judged = core::checkMesh(core::extractMesh(sculptor->mesh()));
        QVERIFY(judged.printReady() && judged.components == 1 && judged.genus == 0);
        QCOMPARE(report.asymmetric, x < 8);
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
    QCOMPARE(clay::dabOnce(*sculptor, joining(10), {4, 0, clay::ballRadius}).outcome, DabOutcome::Refused);
    QCOMPARE(sculptor->mesh().stateHash(), before);
    QCOMPARE(clay::dabOnce(*sculptor, joining(10), {0, 30, 40}).outcome, DabOutcome::Added);
}

FETTLE_TEST(TestSolidBoolean)
#include "tst_solid_boolean.moc"
