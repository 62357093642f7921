// Tests what the figures of the paper show. Figures 5 and 6 are tested in tst_remesh, Figure 16 in tst_dab_pipeline.

#include "core/analysis/mesh_check.h"
#include "core/sculpt/remesh/remesh.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

using core::BrushShape;
using core::DabReport;
using core::Mesh;
using core::Sculptor;
using core::Slot;
using core::StrokeSettings;
using core::Tool;
using core::TriangleMesh;
using core::Vec3;
using mesh_asserts::sculptable;
using mesh_asserts::volumeOf;

namespace
{
constexpr double gap = 0.06; ///< gap between the ends of the cut ring, which represent the ear and the neck in Figure 4

/// Sculpts one dab at `target`, seen from outside, with either brush shape.
DabReport dabAt(Sculptor& sculptor, const StrokeSettings& settings, const Vec3& target, const Vec3& outward)
{
    core::StrokeSample sample;
    sample.position = settings.brush == BrushShape::Ray ? Vec3(target + 0.01 * outward) : target;
    sample.direction = -outward;
    sculptor.beginStroke(settings);
    const DabReport report = sculptor.addSample(sample).at(0);
    sculptor.endStroke();
    return report;
}

std::vector<Vec3> pointsWhere(const Mesh& mesh, const std::function<bool(const Vec3&)>& takes)
{
    std::vector<Vec3> points;
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (mesh.isVertex(v) && takes(mesh.point(v).cast<double>()))
            points.push_back(mesh.point(v).cast<double>());
    }
    std::ranges::sort(points, [](const Vec3& a, const Vec3& b) { return std::ranges::lexicographical_compare(a, b); });
    return points;
}

/// Returns the genus summed over all components. For each, V - E + F = 2 - 2 x handles.
std::int64_t genus(const Mesh& mesh)
{
    return core::checkMesh(mesh_asserts::surfaceOf(mesh)).genus.value_or(-1);
}

/// Returns the mean distance of the vertices in a ball from the mean of their neighbours.
double roughness(const Mesh& mesh, const core::Sphere& ball)
{
    double sum = 0;
    int count = 0;
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (!mesh.isVertex(v) || (mesh.point(v).cast<double>() - ball.center).norm() > ball.radius)
            continue;
        Vec3 around = Vec3::Zero();
        mesh.forEachOutgoing(v, [&](Slot h) { around += mesh.point(mesh.to(h)).cast<double>(); });
        sum += (mesh.point(v).cast<double>() - around / mesh.valence(v)).norm();
        ++count;
    }
    return sum / count;
}

/// Returns the extent in z of the vertices in a ball.
double relief(const Mesh& mesh, const core::Sphere& ball)
{
    const std::vector<Vec3> points =
        pointsWhere(mesh, [&](const Vec3& p) { return (p - ball.center).norm() <= ball.radius; });
    const auto [low, high] = std::ranges::minmax(points, {}, [](const Vec3& p) { return p.z(); });
    return high.z() - low.z();
}
} // namespace

class TestPaperFigures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void figure4_onASimpleSurfaceBothBrushesDoTheSame();
    void figure4_nextToAFoldTheRayBrushTakesTheNearSheet();
    void figure7_illegalCollapsesAreRefused_data();
    void figure7_illegalCollapsesAreRefused();
    void figure7_neckIsNotCollapsed();
    void figure11_fourToolsOnOnePart_data();
    void figure11_fourToolsOnOnePart();
    void figure12_fingersPulledIntoEachOtherJoin_data();
    void figure12_fingersPulledIntoEachOtherJoin();
    void figure13_theEndsOfARingJoin();
    void figure21_aBridgeIsOneTube_data();
    void figure21_aBridgeIsOneTube();
    void figure15_withAndWithoutFusion_data() { figure12_fingersPulledIntoEachOtherJoin_data(); }
    void figure15_withAndWithoutFusion();
    void pushThroughASlab_piercesIt();
    void largeBrush_doesNotPierceAWall();
    void pinch_cutsANeck();
};

/// Figure 4 (a, b, c), the back of the dog. A path along edges can be longer than the straight line, so the ray brush
/// reaches slightly less far.
void TestPaperFigures::figure4_onASimpleSurfaceBothBrushesDoTheSame()
{
    const Vec3 top(0, 0, 1);
    std::map<BrushShape, DabReport> reports;
    for (BrushShape brush : {BrushShape::Sphere, BrushShape::Ray}) {
        Sculptor sculptor(sculptable(core::icosphere(5, 1)));
        StrokeSettings settings;
        settings.radius = 0.2;
        settings.brush = brush;
        reports[brush] = dabAt(sculptor, settings, top, top);
        const std::vector<Vec3> raised = pointsWhere(sculptor.mesh(), [](const Vec3& p) { return p.norm() > 1.001; });
        QVERIFY(raised.size() > 50);
        for (const Vec3& p : raised)
            QVERIFY((p - top).norm() < 0.22);
        VERIFY_VALID(sculptor.mesh());
    }
    const DabReport &sphere = reports[BrushShape::Sphere], &ray = reports[BrushShape::Ray];
    QVERIFY(ray.touchedVertices <= sphere.touchedVertices);
    QVERIFY2(ray.touchedVertices >= 0.7 * sphere.touchedVertices, qPrintable(QString::number(ray.touchedVertices)));
    QVERIFY(std::abs(ray.reached / sphere.reached - 1) < 0.05);
}

/// Figure 4 (d, e, f), the collar beside the ear. The ends of the ring are connected only the long way around.
void TestPaperFigures::figure4_nextToAFoldTheRayBrushTakesTheNearSheet()
{
    const Vec3 neck(1, gap / 2, 0), outward(0, -1, 0); // pole of one end, which faces the other end
    const auto ear = [](const Vec3& p) { return p.x() > 0.5 && p.y() < 0; };
    const auto neckSide = [](const Vec3& p) { return p.x() > 0.5 && p.y() > 0; };
    const TriangleMesh ring = clay::cutRing(gap);
    for (BrushShape brush : {BrushShape::Ray, BrushShape::Sphere}) {
        Sculptor sculptor(sculptable(ring));
        const std::vector<Vec3> earBefore = pointsWhere(sculptor.mesh(), ear),
                                neckBefore = pointsWhere(sculptor.mesh(), neckSide);
        StrokeSettings settings;
        settings.tool = Tool::Push; // moves the surface away from the other end
        settings.radius = 0.15;
        settings.strength = 0.5;
        settings.brush = brush;
        const DabReport report = dabAt(sculptor, settings, neck, outward);
        QVERIFY(report.outcome == core::DabOutcome::Committed && report.touchedVertices > 20);
        QVERIFY(pointsWhere(sculptor.mesh(), neckSide) != neckBefore);
        QCOMPARE(pointsWhere(sculptor.mesh(), ear) == earBefore, brush == BrushShape::Ray);
        VERIFY_VALID(sculptor.mesh());
    }
}

/// Two adjacent vertices p and q, 0.3 apart, are selected on top of a solid. Their flat star is symmetric under a half
/// turn, so a collapse of p to q is illegal exactly if that of q to p is.
void TestPaperFigures::figure7_illegalCollapsesAreRefused_data()
{
    // x of a common neighbour of p and q, whose edge to b points past p or between p and q
    QTest::addColumn<double>("ax");
    QTest::addColumn<double>("detail");
    QTest::addColumn<int>("collapses");
    QTest::newRow("legal") << 0.25 << 2.0 << 1;
    QTest::newRow("a face would turn over") << 0.1 << 2.0 << 0;
    QTest::newRow("an edge would exceed d_detail") << 0.25 << 0.72 << 0;
}

void TestPaperFigures::figure7_illegalCollapsesAreRefused()
{
    QFETCH(double, ax);
    QFETCH(double, detail);
    enum { P, Q, A, B, C, D, E, F, Apex };
    // If ax is below 0.15, the line from b through a passes between p and the midpoint of p and q.
    const float x = static_cast<float>(ax), far = ax < 0.15 ? 1.0f : 0.7f;
    TriangleMesh shape;
    shape.points = {{0, 0, 0},        {0.3f, 0, 0},    {x, -0.35f, 0},
                    {0.15f, -far, 0}, {-0.6f, 0, 0},   {0.3f - x, 0.35f, 0},
                    {0.9f, 0, 0},     {0.15f, far, 0}, {0.15f, 0, -0.7f}};
    shape.triangles = {{P, A, Q}, {P, B, A}, {P, C, B}, {P, D, C},    {Q, D, P},    {Q, F, D},    {Q, E, F},
                       {Q, A, E}, {A, B, E}, {D, F, C}, {E, B, Apex}, {F, E, Apex}, {C, F, Apex}, {B, C, Apex}};
    const auto mesh = sculptable(shape);
    VERIFY_VALID(*mesh);
    core::Region region;
    region.add(P, 0);
    region.add(Q, 0);
    mesh->beginStroke();
    core::MeshEditor edit(*mesh);
    const core::RemeshCounts counts = optimise(edit, region, {detail, 0.32});
    QTEST(static_cast<int>(counts.collapses), "collapses");
    VERIFY_VALID(*mesh);
}

/// The three edges around a neck are not a face. Collapsing one of them would leave an edge with four faces.
void TestPaperFigures::figure7_neckIsNotCollapsed()
{
    std::vector<Vec3> hourglass = {{0, -1, 0}, {0.6, -0.8, 0}, {0.1, 0, 0}, {0.6, 0.8, 0}, {0, 1, 0}};
    const auto mesh = sculptable(clay::revolved(hourglass, 3));
    core::Region region;
    for (Slot v = 0; v < mesh->slots().vertices; ++v) {
        if (mesh->point(v).y() == 0)
            region.add(v, 0);
    }
    QCOMPARE(region.size(), 3u);
    mesh->beginStroke();
    core::MeshEditor edit(*mesh);
    const core::RemeshCounts counts = optimise(edit, region, {5, 1});
    QCOMPARE(counts.collapses, std::uint64_t(0));
    VERIFY_VALID(*mesh);
}

void TestPaperFigures::figure11_fourToolsOnOnePart_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::newRow("pull") << Tool::Pull;
    QTest::newRow("push") << Tool::Push;
    QTest::newRow("flatten") << Tool::Flatten;
    QTest::newRow("smooth") << Tool::Smooth;
}

/// The paper says that tools "can be halted at any time": the mesh is valid between sub-steps, and each dab continues
/// the change of the previous one.
void TestPaperFigures::figure11_fourToolsOnOnePart()
{
    QFETCH(Tool, tool);
    constexpr int dabs = 5;
    const Vec3 top(0, 0, 1);
    const core::Sphere inner = {top, 0.3};
    Sculptor sculptor(sculptable(shapes::noisy(core::icosphere(4, 1), 0.008f, 11)));
    const auto measure = [&](const Mesh& mesh) {
        switch (tool) {
        case Tool::Pull:
            return -volumeOf(mesh);
        case Tool::Push:
            return volumeOf(mesh);
        case Tool::Flatten:
            return relief(mesh, inner);
        default:
            return roughness(mesh, inner);
        }
    };
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = 0.5;
    settings.strength = tool == Tool::Flatten ? 0.15 : 0.5;
    std::string unsound;
    sculptor.setBetweenSubsteps([&] { unsound += mesh_asserts::unsoundness(sculptor.mesh()); });
    const double start = measure(sculptor.mesh());
    double before = start;
    for (int i = 0; i < dabs; ++i) {
        dabAt(sculptor, settings, top, top);
        const double after = measure(sculptor.mesh());
        QVERIFY2(after < before, qPrintable(QStringLiteral("%1 after %2").arg(after).arg(before)));
        before = after;
    }
    if (tool == Tool::Flatten || tool == Tool::Smooth)
        QVERIFY2(before < 0.6 * start, qPrintable(QStringLiteral("%1 of %2").arg(before).arg(start)));
    else
        QVERIFY(std::abs(before - start) > 0.01); // change of the ball's volume, which was 4.19
    QVERIFY2(unsound.empty(), unsound.c_str());
    VERIFY_VALID(sculptor.mesh());
}

void TestPaperFigures::figure12_fingersPulledIntoEachOtherJoin_data()
{
    QTest::addColumn<bool>("fusion");
    QTest::newRow("with fusion") << true;
    QTest::newRow("without") << false;
}

/// Pulls the facing sides of both fingers until they meet. They join to one part, or they stop at contact without
/// fusion.
void TestPaperFigures::figure12_fingersPulledIntoEachOtherJoin()
{
    QFETCH(bool, fusion);
    Sculptor sculptor(sculptable(clay::twoFingers(0.2)));
    QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()), 4);
    StrokeSettings settings;
    settings.radius = 0.3;
    settings.fusion = fusion;
    for (int i = 0; i < 8; ++i) {
        for (double side : {-1.0, 1.0}) {
            const auto facing = sculptor.hit({{0, 0.01, 0.02}, {side, 0, 0}});
            if (facing)
                dabAt(sculptor, settings, facing->position, Vec3(-side, 0, 0));
            VERIFY_VALID(sculptor.mesh());
        }
    }
    QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()), fusion ? 2 : 4);
    QCOMPARE(sculptor.totals().fusions > 0, fusion);
}

/// Joining two places of one part adds a handle.
void TestPaperFigures::figure13_theEndsOfARingJoin()
{
    Sculptor sculptor(sculptable(clay::cutRing(gap)));
    QCOMPARE(genus(sculptor.mesh()), 0);
    StrokeSettings settings;
    settings.radius = 0.2;
    for (int i = 0; i < 6; ++i) {
        dabAt(sculptor, settings, {1, gap / 2, 0}, {0, -1, 0});
        VERIFY_VALID(sculptor.mesh());
    }
    QCOMPARE(genus(sculptor.mesh()), 1);
    QVERIFY(sculptor.totals().fusions > 0);
}

/// Drags one finger across the other. Without fusion the paper's mesh intersects itself; Fettle's stops at contact.
void TestPaperFigures::figure15_withAndWithoutFusion()
{
    QFETCH(bool, fusion);
    Sculptor sculptor(sculptable(clay::twoFingers(0.1)));
    StrokeSettings settings;
    settings.radius = 0.25;
    settings.fusion = fusion;
    settings.strength = 2;
    std::string unsound;
    sculptor.setBetweenSubsteps([&] { unsound += mesh_asserts::unsoundness(sculptor.mesh()); });
    for (int i = 0; i < 6; ++i)
        dabAt(sculptor, settings, {-0.05 + 0.02 * i, 0.1 * i, 0}, {1, 0, 0});
    QVERIFY2(unsound.empty(), unsound.c_str());
    VERIFY_VALID(sculptor.mesh());
    QCOMPARE(sculptor.totals().fusions > 0, fusion);
    QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()) == 4, !fusion);
}

void TestPaperFigures::figure21_aBridgeIsOneTube_data()
{
    QTest::addColumn<core::Symmetry>("symmetry");
    QTest::addColumn<Vec3>("offset");
    QTest::addColumn<int>("bridges");
    QTest::newRow("alone") << core::Symmetry::None << Vec3(0, 0.02, 0) << 1;
    QTest::newRow("on the mirror's plane") << core::Symmetry::Y << Vec3(0, 0, 0) << 1;
    QTest::newRow("about the plane") << core::Symmetry::Y << Vec3(0, 0.01, 0.01) << 1;
    QTest::newRow("with its image") << core::Symmetry::Y << Vec3(0, 0.3, 0) << 2;
}

/// Pulls a bridge from one ball to another and continues in it. The joint must not have holes.
void TestPaperFigures::figure21_aBridgeIsOneTube()
{
    QFETCH(core::Symmetry, symmetry);
    QFETCH(Vec3, offset);
    QFETCH(int, bridges);
    StrokeSettings settings;
    settings.radius = 0.16;
    settings.strength = 1.5;
    settings.spacing = 0.12;
    settings.symmetry = symmetry;
    for (float between : {0.2f, 0.3f, 0.37f, 0.45f}) {
        const TriangleMesh ball = core::icosphere(4, 1);
        Sculptor sculptor(sculptable(shapes::together(ball, shapes::moved(ball, {2 + between, 0, 0}))));
        sculptor.beginStroke(settings);
        for (double x : {0.95, 1.1 + between}) {
            core::StrokeSample sample;
            sample.position = Vec3(x, 0, 0) + offset;
            sculptor.addSample(sample);
        }
        sculptor.endStroke();
        VERIFY_VALID(sculptor.mesh());
        QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()), 4 - 2 * bridges);
        QCOMPARE(genus(sculptor.mesh()), bridges - 1);
    }
}

void TestPaperFigures::pushThroughASlab_piercesIt()
{
    Sculptor sculptor(sculptable(clay::slab(2, 0.1, 16)));
    StrokeSettings settings;
    settings.tool = Tool::Push;
    settings.radius = 0.3;
    for (int i = 0; i < 12; ++i) {
        const auto above = sculptor.hit({{0.03, 1, 0.02}, {0, -1, 0}});
        if (!above)
            break; // the slab is pierced here
        dabAt(sculptor, settings, above->position, {0, 1, 0});
        VERIFY_VALID(sculptor.mesh());
    }
    QVERIFY(!sculptor.hit({{0.03, 1, 0.02}, {0, -1, 0}}));
    QCOMPARE(genus(sculptor.mesh()), 1);
}

/// Pull, flatten and smooth must not pierce a wall, even if the brush is much larger than the wall is thick.
void TestPaperFigures::largeBrush_doesNotPierceAWall()
{
    for (Tool tool : {Tool::Pull, Tool::Flatten, Tool::Smooth}) {
        Sculptor sculptor(sculptable(clay::slab(2, 0.1, 16)));
        StrokeSettings settings;
        settings.tool = tool;
        settings.radius = 0.6;
        settings.strength = 0.5;
        for (int i = 0; i < 4; ++i) {
            dabAt(sculptor, settings, {0.1 * i, 0.05, 0}, {0, 1, 0});
            VERIFY_VALID(sculptor.mesh());
            QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()), 2);
        }
    }
}

/// Pushes in a dumbbell all around its thin handle.
void TestPaperFigures::pinch_cutsANeck()
{
    std::vector<Vec3> dumbbell = {{0, -1, 0}};
    for (int i = 1; i < 40; ++i) {
        const double y = -1 + i / 20.0;
        dumbbell.emplace_back(std::sqrt(1 - y * y) * (0.12 + 0.4 * y * y), y, 0);
    }
    dumbbell.emplace_back(0, 1, 0);
    Sculptor sculptor(sculptable(clay::revolved(dumbbell, 24)));
    StrokeSettings settings;
    settings.tool = Tool::Push;
    settings.radius = 0.2;
    for (int i = 0; i < 12; ++i) {
        dabAt(sculptor, settings, Vec3::Zero(), {1, 0, 0});
        VERIFY_VALID(sculptor.mesh());
    }
    QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()), 4); // Euler number of two parts
    QVERIFY(sculptor.totals().separations > 0);
}

FETTLE_TEST(TestPaperFigures, QCoreApplication)
#include "tst_paper_figures.moc"
