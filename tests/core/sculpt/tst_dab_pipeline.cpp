#include "core/mesh/mesh_builder.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

using clay::dabOnce;
using clay::unitBall;
using core::DabOutcome;
using core::DabReport;
using core::Mesh;
using core::Sculptor;
using core::Slot;
using core::StrokeSettings;
using core::Tool;
using core::Vec3;
using mesh_asserts::isSound;

namespace
{
StrokeSettings settingsFor(Tool tool, double radius = 0.3)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = radius;
    return settings;
}

template <class Visit> void forEachVertex(const Mesh& mesh, Visit visit)
{
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (mesh.isVertex(v))
            visit(v, Vec3(mesh.point(v).cast<double>()));
    }
}
} // namespace

/// Tests tools and modes of a dab by its results.
class TestDabPipeline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void flatten_leavesAPlatform();
    void paint_coloursTheRegionAndMovesNothing();
    void paint_withoutFalloff_setsTheFullColour();
    void colours_areCarriedThroughRemeshing();
    void rayBrush_leavesTheOtherSheetAlone();
    void rayBrush_refinesACoarseFace();
    void uniformTopology_keepsItsLength();
    void addedSphere_isPartOfTheModel();
    void addedSphere_insideIsRefused();
    void addedSphere_tooCloseIsRefused();
    void addedStamp_endsTheStroke();
    void addedSphere_refusedIsAPull();
    void addedSphere_beyondTheWallIsRefused();
};

void TestDabPipeline::flatten_leavesAPlatform()
{
    const auto sculptor = unitBall();
    StrokeSettings settings = settingsFor(Tool::Flatten);
    settings.falloff = 0;
    for (int i = 0; i < 8; ++i)
        dabOnce(*sculptor, settings, {0, 0, 1});
    double lowest = 2, highest = -2;
    forEachVertex(sculptor->mesh(), [&](Slot, const Vec3& p) {
        if ((p - Vec3(0, 0, 0.98)).norm() < 0.2) {
            lowest = std::min(lowest, p.z());
            highest = std::max(highest, p.z());
        }
    });
    // within this area, the height of an unflattened ball varies by 0.02
    QVERIFY2(highest - lowest < 0.002, qPrintable(QString::number(highest - lowest)));
    QVERIFY(isSound(*sculptor));
}

void TestDabPipeline::paint_coloursTheRegionAndMovesNothing()
{
    const auto sculptor = unitBall();
    const core::TriangleMesh before = core::extractMesh(sculptor->mesh());
    StrokeSettings settings = settingsFor(Tool::Paint);
    settings.color = {255, 0, 0};
    const DabReport report = dabOnce(*sculptor, settings, {0, 0, 1});
    QCOMPARE(core::name(report.outcome), core::name(DabOutcome::Committed));
    const core::TriangleMesh after = core::extractMesh(sculptor->mesh());
    QVERIFY(after.points == before.points && after.triangles == before.triangles);
    std::size_t painted = 0;
    forEachVertex(sculptor->mesh(), [&](Slot v, const Vec3& p) {
        const bool inside = (p - Vec3(0, 0, 1)).norm() < 0.3;
        painted += sculptor->mesh().color(v) == core::Rgb() ? 0 : 1;
        QVERIFY(inside || sculptor->mesh().color(v) == core::Rgb());
    });
    QVERIFY(painted > 20);
}

void TestDabPipeline::paint_withoutFalloff_setsTheFullColour()
{
    const auto sculptor = unitBall();
    StrokeSettings settings = settingsFor(Tool::Paint);
    settings.color = {10, 20, 30};
    settings.falloff = 0;
    const DabReport report = dabOnce(*sculptor, settings, {0, 0, 1});
    std::uint32_t painted = 0;
    forEachVertex(sculptor->mesh(),
                  [&](Slot v, const Vec3&) { painted += sculptor->mesh().color(v) == settings.color; });
    QCOMPARE(painted, report.touchedVertices);
}

void TestDabPipeline::colours_areCarriedThroughRemeshing()
{
    const auto sculptor = unitBall();
    StrokeSettings settings = settingsFor(Tool::Paint, 0.5);
    settings.color = {10, 20, 30};
    settings.falloff = 0;
    dabOnce(*sculptor, settings, {0, 0, 1});
    dabOnce(*sculptor, settingsFor(Tool::Pull, 0.1), {0, 0, 1}); // refines the mesh inside the painted area
    forEachVertex(sculptor->mesh(), [&](Slot v, const Vec3& p) {
        if (p.normalized().z() > 0.95)
            QVERIFY(sculptor->mesh().color(v) == settings.color);
    });
}

void TestDabPipeline::rayBrush_leavesTheOtherSheetAlone()
{
    const double thickness = 0.05;
    Sculptor sculptor(mesh_asserts::sculptable(clay::slab(1, thickness, 40)));
    const auto undersideMoved = [&] {
        bool moved = false;
        forEachVertex(sculptor.mesh(), [&](Slot, const Vec3& p) {
            const bool inside = Vec3(p.x(), 0, p.z()).norm() < 0.2;
            moved = moved || (inside && p.y() < 0 && std::abs(p.y() + thickness / 2) > 1e-3);
        });
        return moved;
    };
    StrokeSettings settings = settingsFor(Tool::Pull, 0.15);
    settings.brush = core::BrushShape::Ray;
    const DabReport report = dabOnce(sculptor, settings, {0, 2, 0}, -Vec3::UnitY());
    QVERIFY(report.touchedVertices > 20);
    QVERIFY(!undersideMoved());
    settings.brush = core::BrushShape::Sphere;
    dabOnce(sculptor, settings, {0, thickness / 2, 0});
    QVERIFY(undersideMoved());
    QVERIFY(isSound(sculptor));
}

void TestDabPipeline::rayBrush_refinesACoarseFace()
{
    Sculptor sculptor(mesh_asserts::sculptable(shapes::cube(2)));
    const core::Box box = [&] {
        core::Box result;
        forEachVertex(sculptor.mesh(), [&](Slot, const Vec3& p) { result.extend(p); });
        return result;
    }();
    StrokeSettings settings = settingsFor(Tool::Pull, 0.2);
    settings.brush = core::BrushShape::Ray;
    const Vec3 above = box.center() + Vec3(0.13, 5, 0.21);
    const DabReport report = dabOnce(sculptor, settings, above, -Vec3::UnitY());
    QCOMPARE(core::name(report.outcome), core::name(DabOutcome::Committed));
    QVERIFY(report.touchedVertices > 20);
    QVERIFY(report.reached > 0.95 * report.asked && report.asked > 0.01);
    QVERIFY(isSound(sculptor));
}

void TestDabPipeline::uniformTopology_keepsItsLength()
{
    const auto sculptor = unitBall();
    const double before = static_cast<double>(sculptor->mesh().live().vertices);
    // with adaptive topology, radius 0.1 would refine and 0.8 would coarsen
    StrokeSettings settings = settingsFor(Tool::Smooth, 0.1);
    settings.topology = core::Topology::Uniform;
    dabOnce(*sculptor, settings, {0, 0, 1});
    settings.radius = 0.8;
    dabOnce(*sculptor, settings, {0, 1, 0});
    const double after = static_cast<double>(sculptor->mesh().live().vertices);
    QVERIFY2(std::abs(after / before - 1) < 0.05, qPrintable(QString::number(after / before)));
    settings.detailLength = 0.03;
    dabOnce(*sculptor, settings, {0, 0, 1});
    double longest = 0;
    const Mesh& mesh = sculptor->mesh();
    for (Slot e = 0; e < mesh.slots().edges; ++e) {
        if (!mesh.isEdge(e))
            continue;
        const Vec3 a = mesh.point(mesh.to(2 * e)).cast<double>(), b = mesh.point(mesh.to(2 * e + 1)).cast<double>();
        if ((a - Vec3(0, 0, 1)).norm() < 0.7 && (b - Vec3(0, 0, 1)).norm() < 0.7)
            longest = std::max(longest, (a - b).norm());
    }
    QVERIFY(longest <= 0.03);
    QVERIFY(isSound(*sculptor));
}

void TestDabPipeline::addedSphere_isPartOfTheModel()
{
    const auto sculptor = unitBall();
    const std::uint64_t start = sculptor->mesh().stateHash();
    StrokeSettings settings = settingsFor(Tool::Pull);
    settings.add = true;
    sculptor->beginStroke(settings);
    core::StrokeSample sample;
    sample.position = {0, 0, 1.6};
    QCOMPARE(core::name(sculptor->addSample(sample).at(0).outcome), core::name(DabOutcome::Added));
    sample.radius = 0.1;
    // a stroke adds only one sphere
    QCOMPARE(core::name(sculptor->addSample(sample).at(0).outcome), core::name(DabOutcome::Empty));
    sample.radius.reset();
    sample.position = {0, 0, 1.9};
    QVERIFY(sculptor->addSample(sample).at(0).touchedVertices > 20); // pulls the new sphere
    core::MeshDelta delta = sculptor->endStroke();
    QCOMPARE(mesh_asserts::eulerNumber(sculptor->mesh()), 4);
    QVERIFY(isSound(*sculptor));
    const std::uint64_t end = sculptor->mesh().stateHash();
    sculptor->swap(delta);
    QCOMPARE(sculptor->mesh().stateHash(), start);
    sculptor->swap(delta);
    QCOMPARE(sculptor->mesh().stateHash(), end);
}

void TestDabPipeline::addedSphere_insideIsRefused()
{
    const auto sculptor = unitBall();
    const std::uint64_t start = sculptor->mesh().stateHash();
    StrokeSettings settings = settingsFor(Tool::Pull);
    settings.add = true;
    const DabReport report = dabOnce(*sculptor, settings, {0.1, 0.2, 0});
    QVERIFY(report.outcome == DabOutcome::Refused && report.refusal == core::Refusal::Inside);
    QCOMPARE(sculptor->mesh().stateHash(), start);
}

void TestDabPipeline::addedSphere_tooCloseIsRefused()
{
    const auto sculptor = unitBall();
    StrokeSettings settings = settingsFor(Tool::Pull);
    settings.add = true;
    const DabReport report = dabOnce(*sculptor, settings, {0, 0, 1.32});
    QVERIFY(report.outcome == DabOutcome::Refused && report.refusal == core::Refusal::TooClose);
    QVERIFY(isSound(*sculptor));
}

/// After adding a model, a stamp stroke must end: a second dab would press the stamp into the new part.
void TestDabPipeline::addedStamp_endsTheStroke()
{
    std::vector<std::uint64_t> states;
    for (const bool goesOn : {false, true}) {
        const auto sculptor = unitBall();
        StrokeSettings settings = settingsFor(Tool::Stamp);
        settings.add = true;
        sculptor->beginStroke(settings);
        core::StrokeSample sample;
        sample.position = {0, 0, 1.6};
        QCOMPARE(sculptor->addSample(sample).at(0).outcome, DabOutcome::Added);
        for (const double z : {1.7, 1.3, 1.0}) {
            sample.position.z() = z;
            if (goesOn)
                QCOMPARE(sculptor->addSample(sample).at(0).outcome, DabOutcome::Empty);
        }
        sculptor->endStroke();
        states.push_back(sculptor->mesh().stateHash());
    }
    QCOMPARE(states[0], states[1]);
}

/// A stroke may start too close to add a sphere but too far to pull, or inside the model. It then continues as the pull
/// that would start where it meets the surface.
void TestDabPipeline::addedSphere_refusedIsAPull()
{
    for (const double start : {1.32, 1.31, 0.3}) {
        std::vector<std::uint64_t> states;
        for (const bool adds : {true, false}) {
            const auto sculptor = unitBall();
            StrokeSettings settings = settingsFor(Tool::Pull);
            settings.add = adds;
            sculptor->beginStroke(settings);
            std::vector<DabOutcome> outcomes;
            for (const double z : {start, 1.25, 1.2, 3.0, 1.15}) {
                core::StrokeSample sample;
                sample.position = {0, 0, z};
                outcomes.push_back(sculptor->addSample(sample).at(0).outcome);
            }
            sculptor->endStroke();
            QCOMPARE(outcomes.front(), adds ? DabOutcome::Refused : DabOutcome::Empty);
            QCOMPARE(outcomes.at(1), DabOutcome::Committed);
            QCOMPARE(outcomes.at(3), DabOutcome::Empty); // away from the surface it no longer adds a sphere
            QVERIFY(isSound(*sculptor));
            states.push_back(sculptor->mesh().stateHash());
        }
        QCOMPARE(states[0], states[1]);
    }
}

void TestDabPipeline::addedSphere_beyondTheWallIsRefused()
{
    const auto sculptor = unitBall();
    StrokeSettings settings = settingsFor(Tool::Pull);
    settings.add = true;
    const double wall = sculptor->mesh().lattice().halfVolume();
    const DabReport report = dabOnce(*sculptor, settings, {0, wall - 0.1, 0});
    QVERIFY(report.outcome == DabOutcome::Refused && report.refusal == core::Refusal::Wall);
}

FETTLE_TEST(TestDabPipeline, QCoreApplication)
#include "tst_dab_pipeline.moc"
