#include "core/analysis/winding_number.h"
#include "core/mesh/mesh_builder.h"
#include "core/primitives/starter_models.h"
#include "core/sculpt/deform/brush_model.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>

using core::BrushModel;
using core::DabOutcome;
using core::DabReport;
using core::Sculptor;
using core::Starter;
using core::StrokeSettings;
using core::Tool;
using core::TriangleMesh;
using core::Vec3;
using core::Vec3f;

namespace
{
using clay::ball;
using clay::ballRadius;
using mesh_asserts::isSound;

constexpr double stampRadius = 12;
using Model = std::shared_ptr<const BrushModel>;

Model modelOf(const TriangleMesh& mesh)
{
    return BrushModel::of(mesh, {}).model;
}

/// Returns a flat letter L whose front faces up (+y): neither convex nor mirror symmetric.
TriangleMesh letterL(float thickness = 3)
{
    const std::vector<std::array<float, 2>> outline{{-2, 3}, {-2, -3}, {2, -3}, {2, -1.5}, {-0.5, -1.5}, {-0.5, 3}};
    const std::vector<core::Triangle> top{{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}};
    TriangleMesh mesh;
    for (const float y : {-0.5f * thickness, 0.5f * thickness})
        for (const auto& [x, up] : outline)
            mesh.points.emplace_back(x, y, -up);
    for (const auto& [a, b, c] : top) {
        mesh.triangles.push_back({a + 6, b + 6, c + 6});
        mesh.triangles.push_back({a, c, b});
    }
    for (core::Slot i = 0; i < 6; ++i) {
        const core::Slot j = (i + 1) % 6;
        mesh.triangles.push_back({i, j, j + 6});
        mesh.triangles.push_back({i, j + 6, i + 6});
    }
    return mesh;
}

StrokeSettings stampOf(Model model, bool raises = false)
{
    StrokeSettings settings;
    settings.tool = Tool::Stamp;
    settings.radius = stampRadius;
    settings.model = std::move(model);
    settings.inverted = raises;
    return settings;
}

/// Sculpts one dab. `up`: up direction of the controller, if any.
std::vector<DabReport> dab(Sculptor& sculptor, const StrokeSettings& settings, const Vec3& at,
                           const std::optional<Vec3>& up = {})
{
    sculptor.beginStroke(settings);
    core::StrokeSample sample;
    sample.position = at;
    sample.up = up;
    const std::vector<DabReport> reports = sculptor.addSample(sample);
    sculptor.endStroke();
    return reports;
}

double heightAt(const Sculptor& sculptor, double x, double y)
{
    return sculptor.hit({{x, y, 200}, -Vec3::UnitZ()})->position.z();
}

std::vector<std::pair<const char*, Model>> models()
{
    return {{"ball", nullptr},
            {"cube", modelOf(core::starterModel(Starter::Cube))},
            {"torus", modelOf(core::starterModel(Starter::Torus))},
            {"L", modelOf(letterL())},
            {"bowl", modelOf(clay::bowl())}};
}
} // namespace

class TestBrushModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void of_isOfUnitSize();
    void of_refuses();
    void of_refusesTooManyFaces();
    void spanAt_isTheSolid_data();
    void spanAt_isTheSolid();
    void fingerprint_isOfTheShape();
    void cube_leavesAFlatFloor();
    void cube_raisesAFlatTop();
    void letter_isReadable();
    void letter_turnsWithTheHand();
    void turned_isSymmetric();
    void strength_isItsShare();
    void pressed_isSound_data();
    void pressed_isSound();
    void throughAWall_makesAHole();
    void stroke_standsBeside();
    void symmetric_data();
    void symmetric();
    void undone();
    void added_data();
    void added();
    void added_asItIsHeld();
    void added_isMirrored();
    void added_nearTheSurfaceIsRefused();
    void added_unfitIsRefused();
};

void TestBrushModel::of_isOfUnitSize()
{
    TriangleMesh mesh = core::starterModel(Starter::Torus);
    for (Vec3f& p : mesh.points)
        p = 1000 * p + Vec3f(5, 6, 7);
    const Model model = modelOf(mesh);
    double farthest = 0;
    core::Box box;
    for (const Vec3f& p : model->surface().points) {
        farthest = std::max(farthest, p.cast<double>().norm());
        box.extend(p.cast<double>());
    }
    QVERIFY(std::abs(farthest - 1) < 1e-6);
    QVERIFY(box.center().norm() < 1e-6);
}

void TestBrushModel::of_refuses()
{
    using Fault = BrushModel::Fault;
    const TriangleMesh cube = core::starterModel(Starter::Cube);
    TriangleMesh open = cube, turned = cube, flat = cube, tiny = cube;
    open.triangles.pop_back();
    for (core::Triangle& t : turned.triangles)
        std::swap(t[0], t[1]);
    for (Vec3f& p : flat.points)
        p.y() *= 1e-5f;
    for (Vec3f& p : tiny.points)
        p *= 1e-9f;
    const auto faultOf = [](const TriangleMesh& mesh) {
        const BrushModel::Made made = BrushModel::of(mesh, {});
        return made.model ? Fault::None : made.fault;
    };
    QCOMPARE(faultOf(cube), Fault::None);
    QCOMPARE(faultOf(open), Fault::Unsound);
    QVERIFY(BrushModel::of(open, {}).report.openEdges.count > 0);
    QCOMPARE(faultOf(turned), Fault::Unsound);
    QCOMPARE(faultOf(flat), Fault::TooFlat);
    QCOMPARE(faultOf(tiny), Fault::TooSmall);
    TriangleMesh point = cube;
    for (Vec3f& p : point.points)
        p = {1, 2, 3};
    QCOMPARE(faultOf(point), Fault::TooSmall);
    QCOMPARE(faultOf(TriangleMesh()), Fault::TooSmall);
    TriangleMesh crossing = cube; // two cubes that overlap by half
    for (const Vec3f& p : cube.points)
        crossing.points.push_back(p + 0.5f * (cube.points[0].cwiseAbs()));
    const auto n = static_cast<core::Slot>(cube.points.size());
    for (const auto& [a, b, c] : cube.triangles)
        crossing.triangles.push_back({a + n, b + n, c + n});
    QCOMPARE(faultOf(crossing), Fault::Unsound);
}

void TestBrushModel::of_refusesTooManyFaces()
{
    QCOMPARE(BrushModel::of(core::icosphere(8, 1), {}).fault, BrushModel::Fault::TooManyFaces);
}

void TestBrushModel::spanAt_isTheSolid_data()
{
    QTest::addColumn<int>("which");
    for (int i = 1; i < static_cast<int>(models().size()); ++i)
        QTest::newRow(models()[static_cast<std::size_t>(i)].first) << i;
}

/// Compares spanAt() with the winding number on a grid that meets corners and edges: a span must exist exactly inside
/// the solid, and must contain the point.
void TestBrushModel::spanAt_isTheSolid()
{
    QFETCH(int, which);
    const Model model = models()[static_cast<std::size_t>(which)].second;
    std::vector<Vec3> points;
    for (const Vec3f& p : model->surface().points)
        points.push_back(p.cast<double>());
    const core::WindingNumber winding(points, model->surface().triangles);
    int inside = 0;
    for (double x = -1; x <= 1; x += 0.125) {
        for (double y = -1; y <= 1; y += 0.13) {
            for (double z = -1; z <= 1; z += 0.125) {
                const double number = winding.at({x, y, z});
                const auto span = model->spanAt({x, y, z});
                if (std::abs(number - 0.5) < 0.3) // too near the surface to decide
                    continue;
                QCOMPARE(span.has_value(), number > 0.5);
                inside += span ? 1 : 0;
                if (span)
                    QVERIFY(span->low <= y && y <= span->high &&
                            winding.at({x, 0.5 * (span->low + span->high), z}) > 0.5);
            }
        }
    }
    QVERIFY(inside > 50);
}

void TestBrushModel::fingerprint_isOfTheShape()
{
    TriangleMesh moved = core::starterModel(Starter::Cube);
    for (Vec3f& p : moved.points)
        p *= 2;
    QCOMPARE(modelOf(moved)->fingerprint(), modelOf(core::starterModel(Starter::Cube))->fingerprint());
    QVERIFY(modelOf(letterL())->fingerprint() != modelOf(letterL(2))->fingerprint());
}

/// The cube is pressed in by half its height. Half of its height is the brush radius divided by the square root of 3.
void TestBrushModel::cube_leavesAFlatFloor()
{
    const auto sculptor = ball();
    const auto reports = dab(*sculptor, stampOf(modelOf(core::starterModel(Starter::Cube))), {0, 0, ballRadius});
    QVERIFY(reports[0].outcome == DabOutcome::Committed || reports[0].outcome == DabOutcome::Fallback);
    const double half = stampRadius / std::sqrt(3.0), floor = ballRadius - half;
    for (const double x : {-0.8, -0.4, 0.0, 0.4, 0.8}) {
        for (const double y : {-0.8, 0.0, 0.8}) {
            const double z = heightAt(*sculptor, x * half, y * half);
            QVERIFY2(std::abs(z - floor) < 0.06, qPrintable(QStringLiteral("%1 %2: %3").arg(x).arg(y).arg(z - floor)));
        }
    }
    for (const double beside : {-1.25, 1.25}) {
        const double x = beside * half;
        QVERIFY(std::abs(heightAt(*sculptor, x, 0) - std::sqrt(ballRadius * ballRadius - x * x)) < 0.1);
    }
    QVERIFY(isSound(*sculptor));
}

void TestBrushModel::cube_raisesAFlatTop()
{
    const auto sculptor = ball();
    dab(*sculptor, stampOf(modelOf(core::starterModel(Starter::Cube)), true), {0, 0, ballRadius});
    const double half = stampRadius / std::sqrt(3.0);
    for (const double x : {-0.8, 0.0, 0.8})
        QVERIFY2(std::abs(heightAt(*sculptor, x * half, 0.8 * half) - ballRadius - half) < 0.06,
                 qPrintable(QString::number(heightAt(*sculptor, x * half, 0.8 * half))));
    QVERIFY(std::abs(heightAt(*sculptor, 1.3 * half, 0) - ballRadius) < 1);
    QVERIFY(isSound(*sculptor));
}

/// The letter must be readable: seen from outside, the foot of the L points to the right.
void TestBrushModel::letter_isReadable()
{
    const auto sculptor = ball();
    dab(*sculptor, stampOf(modelOf(letterL()), true), {0, 0, ballRadius});
    const double scale = stampRadius / std::sqrt(4 + 9 + 2.25), top = ballRadius + 1.5 * scale;
    QVERIFY(std::abs(heightAt(*sculptor, -1.2 * scale, 2 * scale) - top) < 0.1);
    QVERIFY(std::abs(heightAt(*sculptor, 1.4 * scale, -2.2 * scale) - top) < 0.1);
    QVERIFY(heightAt(*sculptor, 1 * scale, 1.5 * scale) < ballRadius + 0.1);
}

/// The up direction of the sample turns the letter clockwise by 90 degrees, although it is not perpendicular to the
/// surface normal.
void TestBrushModel::letter_turnsWithTheHand()
{
    const auto sculptor = ball();
    dab(*sculptor, stampOf(modelOf(letterL()), true), {0, 0, ballRadius}, Vec3(1, 0, 0.6));
    const double scale = stampRadius / std::sqrt(4 + 9 + 2.25), top = ballRadius + 1.5 * scale;
    QVERIFY(std::abs(heightAt(*sculptor, 2 * scale, 1.2 * scale) - top) < 0.1);
    QVERIFY(std::abs(heightAt(*sculptor, -2.2 * scale, -1.4 * scale) - top) < 0.1);
    QVERIFY(heightAt(*sculptor, 1.5 * scale, -1 * scale) < ballRadius + 0.1);
    QVERIFY(isSound(*sculptor));
}

void TestBrushModel::turned_isSymmetric()
{
    const auto sculptor = ball();
    StrokeSettings settings = stampOf(modelOf(letterL()));
    settings.symmetry = core::Symmetry::X;
    dab(*sculptor, settings, Vec3(30, 0, 40), Vec3(1, 2, 0.3));
    VERIFY_SYMMETRIC(sculptor->mesh(), core::Symmetry::X);
    QVERIFY(isSound(*sculptor));
}

void TestBrushModel::strength_isItsShare()
{
    const auto sculptor = ball();
    StrokeSettings settings = stampOf(nullptr);
    settings.strength = 0.25;
    dab(*sculptor, settings, {0, 0, ballRadius});
    QVERIFY(std::abs(heightAt(*sculptor, 0, 0) - (ballRadius - 0.25 * stampRadius)) < 0.1);
}

void TestBrushModel::pressed_isSound_data()
{
    QTest::addColumn<int>("which");
    QTest::addColumn<bool>("raises");
    for (int i = 0; i < static_cast<int>(models().size()); ++i) {
        for (const bool raises : byEffort(std::vector{i % 2 == 0}, std::vector{false, true}))
            QTest::addRow("%s %s", models()[static_cast<std::size_t>(i)].first, raises ? "raised" : "pressed")
                << i << raises;
    }
}

/// Stamps a model on the ball and again across the rim of the first stamp. Repeating both gives the same bits.
void TestBrushModel::pressed_isSound()
{
    QFETCH(int, which);
    QFETCH(bool, raises);
    const auto first = ball(), second = ball();
    const StrokeSettings settings = stampOf(models()[static_cast<std::size_t>(which)].second, raises);
    for (Sculptor* sculptor : {first.get(), second.get()}) {
        dab(*sculptor, settings, {0, 0, ballRadius});
        QVERIFY(isSound(*sculptor));
        dab(*sculptor, settings, sculptor->hit({{5, 4, 200}, -Vec3::UnitZ()})->position);
        QVERIFY(isSound(*sculptor));
    }
    QCOMPARE(first->mesh().stateHash(), second->mesh().stateHash());
    QVERIFY(first->mesh().stateHash() != ball()->mesh().stateHash());
}

void TestBrushModel::throughAWall_makesAHole()
{
    Sculptor sculptor(mesh_asserts::sculptable(clay::slab(40, 3, 20)));
    StrokeSettings settings = stampOf(modelOf(core::starterModel(Starter::Cube)));
    settings.radius = 8;
    dab(sculptor, settings, {0, 1.5, 0});
    QVERIFY(isSound(sculptor));
    QVERIFY(sculptor.totals().fusions > 0);
}

/// Dabs of a stamp must not overlap, although the spacing is denser.
void TestBrushModel::stroke_standsBeside()
{
    const auto sculptor = ball();
    StrokeSettings settings = stampOf(nullptr);
    settings.radius = 5;
    settings.spacing = 0.1;
    settings.place = core::Placement::Ray;
    sculptor->beginStroke(settings);
    std::size_t dabs = 0;
    for (int i = 0; i <= 40; ++i) {
        core::StrokeSample sample;
        sample.position = {-20.0 + i, 0, 200};
        dabs += sculptor->addSample(sample).size();
    }
    sculptor->endStroke();
    QVERIFY2(dabs >= 3 && dabs <= 5, qPrintable(QString::number(dabs)));
    QVERIFY(isSound(*sculptor));
}

void TestBrushModel::symmetric_data()
{
    pressed_isSound_data();
}

void TestBrushModel::symmetric()
{
    QFETCH(int, which);
    QFETCH(bool, raises);
    for (const double x : {4.0, -25.0}) {
        const auto sculptor = ball();
        StrokeSettings settings = stampOf(models()[static_cast<std::size_t>(which)].second, raises);
        settings.symmetry = core::Symmetry::X;
        for (const DabReport& report : dab(*sculptor, settings, ballRadius * Vec3(x, 6, 45).normalized()))
            QVERIFY(!report.asymmetric);
        VERIFY_SYMMETRIC(sculptor->mesh(), core::Symmetry::X);
        QVERIFY(isSound(*sculptor));
    }
}

void TestBrushModel::undone()
{
    const auto used = ball(), fresh = ball();
    used->beginStroke(stampOf(modelOf(letterL())));
    core::StrokeSample sample;
    sample.position = {0, 0, ballRadius};
    used->addSample(sample);
    core::MeshDelta delta = used->endStroke();
    used->swap(delta);
    QCOMPARE(used->mesh().stateHash(), fresh->mesh().stateHash());
    for (Sculptor* sculptor : {used.get(), fresh.get()})
        dab(*sculptor, stampOf(modelOf(letterL())), {0, 20, 45});
    QCOMPARE(used->mesh().stateHash(), fresh->mesh().stateHash());
}

void TestBrushModel::added_data()
{
    QTest::addColumn<int>("which");
    QTest::addColumn<int>("genus");
    QTest::newRow("cube") << 1 << 0;
    QTest::newRow("torus") << 2 << 1;
    QTest::newRow("L") << 3 << 0;
}

/// Adds a model in empty space with Pull and with Stamp. It must be upright and have the radius of the brush.
void TestBrushModel::added()
{
    QFETCH(int, which);
    QFETCH(int, genus);
    const Model model = models()[static_cast<std::size_t>(which)].second;
    for (const Tool tool : {Tool::Pull, Tool::Stamp}) {
        const auto sculptor = ball();
        StrokeSettings settings = stampOf(model);
        settings.tool = tool;
        settings.add = true;
        const Vec3 center(100, 20, -10);
        QCOMPARE(dab(*sculptor, settings, center)[0].outcome, DabOutcome::Added);
        const core::MeshReport report = core::checkMesh(core::extractMesh(sculptor->mesh()));
        QCOMPARE(report.components, std::size_t(2));
        QCOMPARE(*report.genus, genus);
        QVERIFY(isSound(*sculptor));
        core::Box box, expected;
        for (core::Slot v = 0; v < sculptor->mesh().slots().vertices; ++v) {
            const Vec3 p = sculptor->mesh().point(v).cast<double>();
            if (sculptor->mesh().isVertex(v) && p.x() > 60)
                box.extend(p);
        }
        for (const Vec3f& p : model->surface().points)
            expected.extend(center + stampRadius * p.cast<double>());
        QVERIFY((box.min() - expected.min()).norm() < 1e-3 && (box.max() - expected.max()).norm() < 1e-3);
    }
}

/// The added model's y axis follows the up direction of the controller, here x, and its -x axis points along y.
void TestBrushModel::added_asItIsHeld()
{
    const Model model = modelOf(letterL());
    const auto sculptor = ball();
    StrokeSettings settings = stampOf(model);
    settings.add = true;
    const Vec3 center(100, 20, -10);
    QCOMPARE(dab(*sculptor, settings, center, Vec3(2, 0, 0))[0].outcome, DabOutcome::Added);
    for (const Vec3f& p : model->surface().points) {
        const Vec3 at = center + stampRadius * Vec3(p.y(), -p.x(), p.z());
        QVERIFY((sculptor->nearest(at, 1)->position - at).norm() < 1e-3);
    }
}

void TestBrushModel::added_isMirrored()
{
    for (const double side : {1.0, -1.0}) {
        const auto sculptor = ball();
        StrokeSettings settings = stampOf(modelOf(letterL()));
        settings.add = true;
        settings.symmetry = core::Symmetry::X;
        QCOMPARE(dab(*sculptor, settings, {100 * side, 0, 0})[0].outcome, DabOutcome::Added);
        VERIFY_SYMMETRIC(sculptor->mesh(), core::Symmetry::X);
        QVERIFY(isSound(*sculptor));
        // seen from above, the L is unmirrored on the side where the user sculpts
        const double scale = stampRadius / std::sqrt(4 + 9 + 2.25);
        QVERIFY(sculptor->hit({{100 * side + 1.4 * scale, 200, 2.2 * scale}, -Vec3::UnitY()}));
        QVERIFY(!sculptor->hit({{100 * side + 1.4 * scale, 200, -2.2 * scale}, -Vec3::UnitY()}));
    }
}

void TestBrushModel::added_nearTheSurfaceIsRefused()
{
    const auto sculptor = ball();
    const std::uint64_t before = sculptor->mesh().stateHash();
    StrokeSettings settings = stampOf(modelOf(letterL()));
    settings.add = true;
    for (const auto& [x, refusal] :
         {std::pair(62.5, core::Refusal::TooClose), {0.0, core::Refusal::Inside}, {1e4, core::Refusal::Wall}}) {
        const DabReport report = dab(*sculptor, settings, {x, 0, 0})[0];
        QVERIFY(report.outcome == DabOutcome::Refused && report.refusal == refusal);
    }
    QCOMPARE(sculptor->mesh().stateHash(), before);
}

/// The plate is so thin and the brush so small that all vertices would be in one layer of the lattice.
void TestBrushModel::added_unfitIsRefused()
{
    const auto sculptor = ball();
    const std::uint64_t before = sculptor->mesh().stateHash();
    StrokeSettings settings = stampOf(modelOf(letterL(0.008f)));
    settings.add = true;
    settings.radius = 20 * sculptor->mesh().lattice().unit();
    const DabReport report = dab(*sculptor, settings, {100, 0, 0})[0];
    QCOMPARE(report.outcome, DabOutcome::Refused);
    QCOMPARE(report.refusal, core::Refusal::Unfit);
    QCOMPARE(core::shortfallOf(report), core::Shortfall::Unfit);
    QCOMPARE(sculptor->mesh().stateHash(), before);
}

FETTLE_TEST(TestBrushModel, QCoreApplication)
#include "tst_brush_model.moc"
