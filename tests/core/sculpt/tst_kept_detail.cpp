// Tests dabs on a surface finer than the brush: each vertex must move as the tool's field says, and the others must
// stay.
#include "core/sculpt/deform/deform.h"
#include "core/stroke/stroke_anchor.h"
#include "core/stroke/stroke_path.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>

using core::Dab;
using core::Mesh;
using core::Sculptor;
using core::Slot;
using core::Stroke;
using core::StrokeSettings;
using core::Tool;
using core::Topology;
using core::Vec3;

namespace
{
using clay::ballRadius;

/// Returns a ball with waves eight edges long in all directions.
core::TriangleMesh wavyBall()
{
    core::TriangleMesh ball = core::icosphere(6, ballRadius);
    for (core::Vec3f& p : ball.points)
        p *= 1 + 0.01f * std::sin(0.9f * p.x()) * std::sin(0.9f * p.y()) * std::sin(0.9f * p.z());
    return ball;
}

/// Returns a stroke of one effective dab. A drag tool has two samples: it grabs with the first and moves with the
/// second.
Stroke strokeOf(Tool tool, double radius)
{
    Stroke stroke;
    stroke.settings.tool = tool;
    stroke.settings.topology = Topology::Refine;
    stroke.settings.radius = radius;
    core::StrokeSample sample;
    sample.position = ballRadius * Vec3(0.3, 0.4, 0.866);
    sample.direction = -sample.position;
    stroke.samples.push_back(sample);
    if (core::isDragTool(tool)) {
        sample.position += 0.1 * radius * Vec3(0.8, -0.6, 0);
        stroke.samples.push_back(sample);
    }
    return stroke;
}

/// Returns the last dab of a stroke with one dab per sample.
Dab lastDab(const Stroke& stroke)
{
    core::StrokePath path(stroke.settings);
    core::StrokeAnchor anchor(stroke.settings);
    Dab dab;
    for (const core::StrokeSample& sample : stroke.samples) {
        path.add(sample);
        dab = path.next([](const Vec3& position, const Vec3&) { return std::optional(position); })->dab;
        anchor.place(dab);
    }
    return dab;
}

/// The vertices under the brush, with their positions before and after the tool's field.
struct Expected
{
    core::Region region;
    std::vector<Vec3> before; ///< positions before the dab; index: vertex slot

    Expected(const Mesh& mesh, const Stroke& stroke)
    {
        const core::FaceOctree octree(mesh);
        std::vector<Slot> candidates;
        Dab dab = lastDab(stroke);
        selectSphere(region, candidates, mesh, octree, {dab.position, dab.radius});
        dab.axis = meanNormal(region, mesh);
        planDeformation(region, {mesh, stroke.settings, dab, {}});
        for (Slot v = 0; v < mesh.slots().vertices; ++v)
            before.push_back(mesh.point(v).cast<double>());
    }
    Vec3 after(Slot v) const { return before[v] + region.plan(v); }
};

double shortestEdgeAt(const Mesh& mesh, Slot v)
{
    double shortest = INFINITY;
    mesh.forEachOutgoing(
        v, [&](Slot h) { shortest = std::min(shortest, double((mesh.point(mesh.to(h)) - mesh.point(v)).norm())); });
    return shortest;
}

std::vector<core::DabReport> play(Sculptor& sculptor, const Stroke& stroke)
{
    std::vector<core::DabReport> reports;
    sculptor.beginStroke(stroke.settings);
    for (const core::StrokeSample& sample : stroke.samples)
        reports = sculptor.addSample(sample);
    sculptor.endStroke();
    return reports;
}

void addTools()
{
    using enum Tool;
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<double>("radius");
    for (const Tool tool :
         {Pull, Push, Inflate, Clay, Layer, Flatten, Scrape, Smooth, Pinch, Crease, Grab, SnakeHook, Twist}) {
        for (const double edges : {5, 10, 20})
            QTest::addRow("%s, %g edges", std::string(name(tool)).c_str(), edges) << tool << 0.9 * edges;
    }
}
} // namespace

class TestKeptDetail : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void refine_movesEachVertexByTheField_data() { addTools(); }
    void refine_movesEachVertexByTheField();
    void keep_addsAndRemovesNothing_data() { addTools(); }
    void keep_addsAndRemovesNothing();
    void refine_isAdaptiveWhereTheBrushIsFiner();
    void refine_collapsesWhatTheStrokeSqueezed();
    void adaptive_losesDetail();
};

/// The new surface must be near each vertex's target position: within a tenth of the vertex's shortest edge for 95 % of
/// the vertices, and within that edge for all. The area must not lose vertices.
void TestKeptDetail::refine_movesEachVertexByTheField()
{
    QFETCH(Tool, tool);
    QFETCH(double, radius);
    Sculptor sculptor(mesh_asserts::sculptable(wavyBall()));
    const Stroke stroke = strokeOf(tool, radius);
    const Expected expected(sculptor.mesh(), stroke);
    std::vector<double> shortest;
    for (Slot v = 0; v < sculptor.mesh().slots().vertices; ++v)
        shortest.push_back(shortestEdgeAt(sculptor.mesh(), v));

    const std::vector<core::DabReport> reports = play(sculptor, stroke);
    QCOMPARE(reports.size(), std::size_t(1));
    QVERIFY(reports[0].outcome == core::DabOutcome::Committed);
    int off = 0;
    double farthest = 0;
    expected.region.forEach([&](Slot v) {
        const std::optional<core::SurfaceHit> nearest = sculptor.nearest(expected.after(v), radius);
        QVERIFY(nearest);
        const double deviation = (nearest->position - expected.after(v)).norm() / shortest[v];
        farthest = std::max(farthest, deviation);
        off += deviation > 0.1;
    });
    const QByteArray seen = QByteArray::number(off) + " off of " + QByteArray::number(expected.region.size()) +
                            ", farthest " + QByteArray::number(farthest) + ", now " +
                            QByteArray::number(reports[0].touchedVertices);
    if (qEnvironmentVariableIsSet("FETTLE_TRACE"))
        qInfo("%s", seen.constData());
    QVERIFY2(farthest <= 1 && off <= 0.05 * expected.region.size(), seen);
    QVERIFY(reports[0].touchedVertices >= expected.region.size());
    QVERIFY(mesh_asserts::badFaces(sculptor.mesh()).empty());
}

void TestKeptDetail::keep_addsAndRemovesNothing()
{
    QFETCH(Tool, tool);
    QFETCH(double, radius);
    Sculptor sculptor(mesh_asserts::sculptable(wavyBall()));
    Stroke stroke = strokeOf(tool, radius);
    stroke.settings.topology = Topology::Keep;
    const core::SlotCounts before = sculptor.mesh().live();
    const std::vector<core::DabReport> reports = play(sculptor, stroke);
    QVERIFY(reports[0].outcome == core::DabOutcome::Committed);
    QCOMPARE(sculptor.mesh().live().vertices, before.vertices);
    QCOMPARE(sculptor.mesh().live().faces, before.faces);
    const core::SculptorTotals totals = sculptor.totals();
    QCOMPARE(totals.splits + totals.collapses + totals.flips, std::uint64_t(0));
}

void TestKeptDetail::refine_isAdaptiveWhereTheBrushIsFiner()
{
    Stroke stroke = strokeOf(Tool::Pull, 12);
    Sculptor refined(mesh_asserts::sculptable(core::icosphere(3, ballRadius)));
    play(refined, stroke);
    stroke.settings.topology = Topology::Adaptive;
    Sculptor adapted(mesh_asserts::sculptable(core::icosphere(3, ballRadius)));
    play(adapted, stroke);
    QVERIFY(refined.mesh().live().vertices > core::icosphere(3, 1).points.size());
    QVERIFY(mesh_asserts::surfaceOf(refined.mesh()).points == mesh_asserts::surfaceOf(adapted.mesh()).points);
}

/// Repeated pinching must not refine the surface without limit: squeezed edges are collapsed.
void TestKeptDetail::refine_collapsesWhatTheStrokeSqueezed()
{
    Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(6, ballRadius)));
    Stroke stroke = strokeOf(Tool::Pinch, 9);
    stroke.settings.strength = 3;
    stroke.samples.resize(12, stroke.samples[0]);
    const Expected before(sculptor.mesh(), stroke);
    play(sculptor, stroke);
    int gone = 0;
    before.region.forEach([&](Slot v) { gone += sculptor.mesh().isVertex(v) ? 0 : 1; });
    QVERIFY(gone > 0);
    QVERIFY(sculptor.totals().collapses > 0);
    QVERIFY(mesh_asserts::badFaces(sculptor.mesh()).empty());
}

/// The paper's adaptive topology loses the detail that Refine and Keep preserve.
void TestKeptDetail::adaptive_losesDetail()
{
    Sculptor sculptor(mesh_asserts::sculptable(wavyBall()));
    Stroke stroke = strokeOf(Tool::Pull, 18);
    stroke.settings.topology = Topology::Adaptive;
    const Slot before = sculptor.mesh().live().vertices;
    play(sculptor, stroke);
    QVERIFY(sculptor.mesh().live().vertices < before);
}

FETTLE_TEST(TestKeptDetail)
#include "tst_kept_detail.moc"
