// Tests the joints that fusion makes where surfaces meet: one seam without additional handles, tunnels or voids.
#include "core/analysis/mesh_check.h"
#include "core/mesh/mesh_builder.h"
#include "core/mesh/normals.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <map>

using core::Sculptor;
using core::StrokeSettings;
using core::Tool;
using core::Vec3;

namespace
{
core::MeshReport judged(const Sculptor& sculptor)
{
    return core::checkMesh(core::extractMesh(sculptor.mesh()));
}

core::TriangleMesh movedBy(core::TriangleMesh mesh, const core::Vec3f& way)
{
    for (core::Vec3f& p : mesh.points)
        p += way;
    return mesh;
}

/// Sculpts one dab at each place of the path.
void drag(Sculptor& sculptor, const StrokeSettings& settings, const std::vector<Vec3>& path)
{
    sculptor.beginStroke(settings);
    for (const Vec3& place : path) {
        core::StrokeSample sample;
        sample.position = place;
        sculptor.addSample(sample);
    }
    sculptor.endStroke();
}

void drag(Sculptor& sculptor, Tool tool, double radius, const std::vector<Vec3>& path,
          core::Topology topology = core::Topology::Refine)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = radius;
    settings.topology = topology;
    drag(sculptor, settings, path);
}

std::vector<Vec3> line(const Vec3& from, const Vec3& to, double step)
{
    const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step)));
    std::vector<Vec3> path;
    for (int i = 0; i <= count; ++i)
        path.push_back(from + double(i) / count * (to - from));
    return path;
}

/// Returns points on an arc about an axis parallel to z through `center`, between two angles in radians.
std::vector<Vec3> arc(const Vec3& center, double radius, double from, double to, double step)
{
    const int count = static_cast<int>(std::ceil(std::abs(to - from) * radius / step));
    std::vector<Vec3> path;
    for (int i = 0; i <= count; ++i) {
        const double angle = from + (to - from) * i / count;
        path.push_back(center + radius * Vec3(std::cos(angle), std::sin(angle), 0));
    }
    return path;
}

/// Returns the points where edges cross the plane through `center` that contains the z direction and is at `angle`, in
/// radians, from the x axis. Only edges whose first end is less than `within` from `place` count.
std::vector<Vec3> sectionAt(const Sculptor& sculptor, const Vec3& center, double angle, const Vec3& place,
                            double within)
{
    const core::Mesh& mesh = sculptor.mesh();
    const Vec3 normal(-std::sin(angle), std::cos(angle), 0);
    std::vector<Vec3> section;
    for (core::Slot e = 0; e < mesh.slots().edges; ++e) {
        if (!mesh.isEdge(e))
            continue;
        const Vec3 a = mesh.point(mesh.to(2 * e)).cast<double>(), b = mesh.point(mesh.to(2 * e + 1)).cast<double>();
        const double atA = (a - center).dot(normal), atB = (b - center).dot(normal);
        if (atA * atB < 0 && (a - place).norm() < within)
            section.push_back(a + atA / (atA - atB) * (b - a));
    }
    return section;
}

/// Returns the distances from the x axis at which edges cross the plane at x.
std::vector<double> section(const Sculptor& sculptor, double x)
{
    const core::Mesh& mesh = sculptor.mesh();
    std::vector<double> distances;
    for (core::Slot e = 0; e < mesh.slots().edges; ++e) {
        if (!mesh.isEdge(e))
            continue;
        const Vec3 a = mesh.point(mesh.to(2 * e)).cast<double>(), b = mesh.point(mesh.to(2 * e + 1)).cast<double>();
        if ((a.x() - x) * (b.x() - x) < 0)
            distances.push_back((a + (x - a.x()) / (b.x() - a.x()) * (b - a)).tail<2>().norm());
    }
    return distances;
}
} // namespace

class TestJoints : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void snakeHook_isRound();
    void snakeHook_isRoundInABend_data();
    void snakeHook_isRoundInABend();
    void snakeHookLedBack_isAHandle_data();
    void snakeHookLedBack_isAHandle();
    void snakeHookToAWall_staysInIt_data();
    void snakeHookToAWall_staysInIt();
    void snakeHookLedBack_isSymmetric();
    void snakeHookAtThePlane_isAHandle_data();
    void snakeHookAtThePlane_isAHandle();
    void joints_areQuasiUniform_data();
    void joints_areQuasiUniform();
    void eggThroughAPlate_isOneSeam_data();
    void eggThroughAPlate_isOneSeam();
    void fineForkIntoAPlate_joins_data();
    void fineForkIntoAPlate_joins();
    void grabAlongTheSurface_staysInOnePiece_data();
    void grabAlongTheSurface_staysInOnePiece();
    void grabAlongTheSurface_leavesNoTeeth_data();
    void grabAlongTheSurface_leavesNoTeeth();
    void endsOfARing_joinInOneSeam_data();
    void endsOfARing_joinInOneSeam();
    void strongDabs_reachWhatWasAsked();
};

/// A tentacle five radii long has at least ten corners in each cross-section, and its radius shrinks by at most a
/// third.
void TestJoints::snakeHook_isRound()
{
    constexpr double radius = 0.2;
    Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(4, 1)));
    drag(sculptor, Tool::SnakeHook, radius, line({1, 0, 0}, {1 + 6 * radius, 0, 0}, 0.1 * radius));
    double first = 0;
    for (double way = 0.5; way <= 5.5; way += 0.5) {
        const std::vector<double> distances = section(sculptor, 1 + way * radius);
        QVERIFY(distances.size() >= 20); // each corner of the section has at least two edges
        const auto [least, most] = std::ranges::minmax(distances);
        QVERIFY2(least > 0.85 * most, qPrintable(QStringLiteral("%1 to %2").arg(least).arg(most)));
        first = std::max(first, most);
        QVERIFY2(least > 0.66 * first, qPrintable(QStringLiteral("%1 after %2").arg(least).arg(first)));
    }
    QVERIFY(mesh_asserts::badFaces(sculptor.mesh()).empty());
}

void TestJoints::snakeHook_isRoundInABend_data()
{
    QTest::addColumn<double>("bend");
    for (const double bend : {1.5, 2.5, 4.0})
        QTest::addRow("%g radii", bend) << bend;
}

/// A tentacle drawn in a half circle must keep round cross-sections and not flatten to a ribbon.
void TestJoints::snakeHook_isRoundInABend()
{
    QFETCH(double, bend);
    constexpr double radius = 0.2;
    const double curve = bend * radius;
    const Vec3 corner(1 + 2 * radius, 0, 0), center = corner + Vec3(0, curve, 0);
    Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(4, 1)));
    std::vector<Vec3> path = line({1, 0, 0}, corner, 0.1 * radius);
    const std::vector<Vec3> round = arc(center, curve, -M_PI / 2, M_PI / 2, 0.1 * radius);
    path.insert(path.end(), round.begin(), round.end());
    drag(sculptor, Tool::SnakeHook, radius, path);
    for (double angle = -1.2; angle < 1.2; angle += 0.3) {
        const Vec3 place = center + curve * Vec3(std::cos(angle), std::sin(angle), 0);
        const std::vector<Vec3> section = sectionAt(sculptor, center, angle, place, 1.2 * radius);
        QVERIFY(section.size() >= 20); // each of at least ten corners has at least two edges
        Vec3 middle = Vec3::Zero();
        for (const Vec3& p : section)
            middle += p / static_cast<double>(section.size());
        double least = INFINITY, most = 0;
        for (const Vec3& p : section) {
            least = std::min(least, (p - middle).norm());
            most = std::max(most, (p - middle).norm());
        }
        QVERIFY2(least > 0.8 * most, qPrintable(QStringLiteral("%1 to %2").arg(least).arg(most)));
    }
    QVERIFY(mesh_asserts::badFaces(sculptor.mesh()).empty());
}

void TestJoints::snakeHookLedBack_isAHandle_data()
{
    QTest::addColumn<core::TriangleMesh>("model");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("bend");
    QTest::addColumn<double>("step");
    int index = 0;
    for (const double radius : {0.08, 0.12, 0.16, 0.2, 0.3}) {
        for (const double bend : {1.5, 2.0, 3.0}) {
            for (const double step : {0.05, 0.1, 0.2}) {
                if (index++ % byEffort(4, 1) == 0)
                    QTest::addRow("ball, radius %g, bend %g, step %g", radius, bend, step)
                        << core::icosphere(5, 1) << radius << bend << step;
            }
        }
    }
    for (const double radius : {0.12, 0.2})
        QTest::addRow("slab, radius %g", radius) << clay::slab(1, 1, 20) << radius << 2.0 << 0.1;
}

/// A half circle that starts and ends at the model's side must form exactly one handle in one part.
void TestJoints::snakeHookLedBack_isAHandle()
{
    QFETCH(core::TriangleMesh, model);
    QFETCH(double, radius);
    QFETCH(double, bend);
    QFETCH(double, step);
    Sculptor sculptor(mesh_asserts::sculptable(model));
    const double half = bend * radius;
    const auto side = sculptor.hit({{10, -half, 0}, {-1, 0, 0}}), front = sculptor.hit({{10, 0, 0}, {-1, 0, 0}});
    QVERIFY(side && front);
    const Vec3 center(side->position.x(), 0, 0);
    drag(sculptor, Tool::SnakeHook, radius, arc(center, half, -M_PI / 2, M_PI / 2 + 0.9, step * radius));
    const core::MeshReport report = judged(sculptor);
    QVERIFY(report.printReady());
    QVERIFY2(report.genus.value() == 1 && report.components == 1,
             qPrintable(QStringLiteral("genus %1, components %2").arg(report.genus.value()).arg(report.components)));
    const double inner = center.x() + half - 0.7 * radius;
    // a ray passes through the hole of the handle
    QVERIFY(!sculptor.hit({{0.5 * (front->position.x() + inner), 0, 10}, {0, 0, -1}}));
}

void TestJoints::snakeHookToAWall_staysInIt_data()
{
    QTest::addColumn<double>("thickness");
    for (const double thickness : {0.04, 0.1, 0.4})
        QTest::addRow("%g", thickness) << thickness;
}

/// A tentacle from a ball to a plate above it joins both, and must not bulge the far side of the plate.
void TestJoints::snakeHookToAWall_staysInIt()
{
    QFETCH(double, thickness);
    constexpr double radius = 0.16, gap = 0.6;
    const float middle = static_cast<float>(1 + gap + 0.5 * thickness);
    const core::TriangleMesh model =
        shapes::together(core::icosphere(4, 1), movedBy(clay::slab(2, thickness, 30), {0, middle, 0}));
    Sculptor sculptor(mesh_asserts::sculptable(model));
    const double top = sculptor.hit({{0.1, 10, 0.1}, {0, -1, 0}})->position.y();
    drag(sculptor, Tool::SnakeHook, radius, line({0, 1, 0}, {0, 2, 0}, 0.1 * radius));
    const core::MeshReport report = judged(sculptor);
    QVERIFY(report.printReady());
    QVERIFY2(report.genus.value() == 0 && report.components == 1,
             qPrintable(QStringLiteral("genus %1, components %2").arg(report.genus.value()).arg(report.components)));
    for (core::Slot v = 0; v < sculptor.mesh().slots().vertices; ++v)
        QVERIFY(!sculptor.mesh().isVertex(v) || sculptor.mesh().point(v).y() < top + 0.01 * radius);
}

/// The mirror image of the handle must join as well.
void TestJoints::snakeHookLedBack_isSymmetric()
{
    constexpr double radius = 0.2, half = 2 * radius;
    Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(5, 1)));
    StrokeSettings settings;
    settings.tool = Tool::SnakeHook;
    settings.radius = radius;
    settings.topology = core::Topology::Refine;
    settings.symmetry = core::Symmetry::X;
    drag(sculptor, settings, arc({std::sqrt(1 - half * half), 0, 0}, half, -M_PI / 2, M_PI / 2 + 0.9, 0.1 * radius));
    const core::MeshReport report = judged(sculptor);
    QVERIFY(report.printReady());
    QVERIFY(report.genus.value() == 2 && report.components == 1);
    VERIFY_SYMMETRIC(sculptor.mesh(), core::Symmetry::X);
}

void TestJoints::snakeHookAtThePlane_isAHandle_data()
{
    constexpr double step = 0.018; // a tenth of the radius
    QTest::addColumn<std::vector<Vec3>>("path");
    for (const double degrees : {90.0, 60.0, 45.0}) { // to meet its image
        std::vector<Vec3> path = line({0.4, 0, 0.9}, {0.4, 0, 1.4}, step);
        const double angle = degrees * M_PI / 180;
        const std::vector<Vec3> rest = line({0.4, 0, 1.4}, {-0.2, 0, 1.4 + 0.6 / std::tan(angle)}, step);
        path.insert(path.end(), rest.begin(), rest.end());
        QTest::addRow("two tentacles, %g degrees from the plane", degrees) << path;
    }
    for (const double aside : {0.0, 0.02, 0.05, 0.08}) { // back to the ball
        std::vector<Vec3> path = arc({1, 0, 0}, 0.4, -M_PI / 2, M_PI / 2 + 0.9, step);
        for (Vec3& p : path)
            p = {aside, p.y(), p.x()};
        QTest::addRow("one tentacle, %g beside the plane", aside) << path;
    }
}

/// Tentacles that meet at the mirror plane, or a tentacle in it that is led back, must join in one handle by a
/// single union.
void TestJoints::snakeHookAtThePlane_isAHandle()
{
    QFETCH(std::vector<Vec3>, path);
    StrokeSettings settings;
    settings.tool = Tool::SnakeHook;
    settings.radius = 0.18;
    settings.topology = core::Topology::Refine;
    settings.symmetry = core::Symmetry::X;
    Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(5, 1)));
    drag(sculptor, settings, path);
    const core::MeshReport report = judged(sculptor);
    QVERIFY(report.printReady());
    QVERIFY2(report.genus.value() == 1 && report.components == 1,
             qPrintable(QStringLiteral("genus %1, components %2").arg(report.genus.value()).arg(report.components)));
    VERIFY_SYMMETRIC(sculptor.mesh(), core::Symmetry::X);
    QCOMPARE(sculptor.totals().fusions, 1u);
}

void TestJoints::joints_areQuasiUniform_data()
{
    QTest::addColumn<core::TriangleMesh>("model");
    QTest::addColumn<double>("gap");
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<double>("radius");
    const core::TriangleMesh balls =
        shapes::together(movedBy(core::icosphere(5, 1), {-1.15F, 0, 0}), movedBy(core::icosphere(5, 1), {1.15F, 0, 0}));
    core::TriangleMesh plate = clay::slab(3, 0.4, 60);
    for (core::Vec3f& p : plate.points)
        p = core::Vec3f(p.y(), -p.x(), p.z());
    const core::TriangleMesh plates = shapes::together(movedBy(plate, {-0.4F, 0, 0}), movedBy(plate, {0.4F, 0, 0}));
    for (const Tool tool : {Tool::Pull, Tool::Grab, Tool::Inflate, Tool::SnakeHook}) {
        const auto radii = byEffort(std::vector{0.22, 0.45}, std::vector{0.15, 0.22, 0.32, 0.45});
        for (const double radius : radii) {
            const std::string_view name = core::name(tool);
            if (tool != Tool::Inflate || radius > 0.2) // with a small radius Inflate would need many more dabs to join
                QTest::addRow("balls, %s, %g", name.data(), radius) << balls << 0.3 << tool << radius;
            QTest::addRow("fingers, %s, %g", name.data(), radius) << clay::twoFingers(0.2) << 0.2 << tool << radius;
            if (tool != Tool::Inflate || radius > 0.4) // with a small radius Inflate would need many more dabs to join
                QTest::addRow("plates, %s, %g", name.data(), radius) << plates << 0.4 << tool << radius;
        }
    }
}

/// After each dab, including the joining one, the selection must be d_detail-tight (paper, section 3.4). Exception: a
/// split that is refused because its faces would be too narrow.
void TestJoints::joints_areQuasiUniform()
{
    QFETCH(core::TriangleMesh, model);
    QFETCH(double, gap);
    QFETCH(Tool, tool);
    QFETCH(double, radius);
    Sculptor sculptor(mesh_asserts::sculptable(model));
    double longest = 0;
    sculptor.setAfterDab([&](const core::DabReport&) {
        if (const std::optional<core::SelectionQuality> quality = sculptor.selectionQuality())
            longest = std::max(longest, quality->longestEdge);
    });
    const Vec3 left(-0.5 * gap, 0, 0), right(0.5 * gap, 0, 0), inwards(0.3 * radius, 0, 0);
    if (core::isDragTool(tool)) { // starts inside the left model to move only that one
        drag(sculptor, tool, radius, line(left - inwards, right + 2 * inwards, 0.1 * radius));
    } else {
        drag(sculptor, tool, radius, line(left, right, 0.1 * radius));
        drag(sculptor, tool, radius, std::vector<Vec3>(24, right));
    }
    QVERIFY(judged(sculptor).printReady());
    QVERIFY2(longest > 0.5 && longest <= 1.05, qPrintable(QString::number(longest)));
    QVERIFY(sculptor.totals().fusions > 0);
}

void TestJoints::eggThroughAPlate_isOneSeam_data()
{
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("aside");
    QTest::addColumn<core::Topology>("topology");
    for (const double radius : {14.0, 22.0, 40.0}) {
        for (const core::Topology topology : {core::Topology::Refine, core::Topology::Adaptive}) {
            const std::string_view name = core::name(topology);
            QTest::addRow("%g, %s", radius, name.data()) << radius << 7.0 << topology;
        }
    }
}

/// An egg dragged through a plate must fuse with it or leave at most one hole.
void TestJoints::eggThroughAPlate_isOneSeam()
{
    QFETCH(double, radius);
    QFETCH(double, aside);
    QFETCH(core::Topology, topology);
    constexpr float eggHeight = 22;
    core::TriangleMesh egg = core::icosphere(4, 10);
    for (core::Vec3f& p : egg.points)
        p = core::Vec3f(p.x(), 1.35F * p.y() + eggHeight, p.z());
    Sculptor sculptor(mesh_asserts::sculptable(shapes::together(clay::slab(100, 6, 50), egg)));
    drag(sculptor, Tool::Grab, radius, line({aside, eggHeight, 0}, {aside, eggHeight - 48, 0}, 2.5), topology);
    const core::MeshReport report = judged(sculptor);
    QVERIFY(report.printReady());
    QVERIFY2(report.genus.value() <= 1, qPrintable(QString::number(report.genus.value())));
}

void TestJoints::fineForkIntoAPlate_joins_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<double>("half");
    for (const double half : byEffort(std::vector{0.2}, std::vector{0.14, 0.2})) {
        QTest::addRow("grab, %g", half) << Tool::Grab << half;
        QTest::addRow("snake, %g", half) << Tool::SnakeHook << half;
    }
}

/// The mesh is far finer than the brush. A dab must still join it before the work limit of a dab is reached.
void TestJoints::fineForkIntoAPlate_joins()
{
    QFETCH(Tool, tool);
    QFETCH(double, half);
    constexpr double top = 0.1;
    const core::TriangleMesh fork = clay::tube(
        {{-half, top + 0.2, 0}, {-half, top + 0.5, 0}, {half, top + 0.5, 0}, {half, top + 0.2, 0}}, 0.06, 20);
    Sculptor sculptor(mesh_asserts::sculptable(shapes::together(clay::slab(1.6, 2 * top, 80), fork)));
    bool isCapped = false;
    sculptor.setAfterDab([&](const core::DabReport& report) { isCapped = isCapped || report.capped; });
    core::StrokeSettings settings;
    settings.tool = tool;
    settings.radius = 0.7;
    settings.topology = core::Topology::Refine;
    settings.symmetry = core::Symmetry::X;
    drag(sculptor, settings, line({1e-4, top + 0.45, 0}, {1e-4, top + 0.1, 0}, 0.03));
    QVERIFY(!isCapped);
    const core::MeshReport report = judged(sculptor);
    QVERIFY(report.printReady());
    QCOMPARE(report.components, std::size_t(1));
}

void TestJoints::grabAlongTheSurface_staysInOnePiece_data()
{
    QTest::addColumn<core::TriangleMesh>("model");
    QTest::addColumn<Vec3>("start");
    QTest::addColumn<Vec3>("way");
    for (const double radii : {0.5, 1.0, 2.0, 4.0})
        QTest::addRow("ball, %g radii", radii) << core::icosphere(5, 1) << Vec3(0, 0, 1) << Vec3(0, 0.46 * radii, 0);
    for (const double radii : {0.5, 1.0, 2.0, 4.0})
        QTest::addRow("plate, %g radii", radii)
            << clay::slab(5, 0.5, 50) << Vec3(0.1, 0.25, 1) << Vec3(0, 0, -0.46 * radii);
}

/// Dragging along the surface must leave one part, however thin, without an edge longer than 1.5 d_detail.
void TestJoints::grabAlongTheSurface_staysInOnePiece()
{
    QFETCH(core::TriangleMesh, model);
    QFETCH(Vec3, start);
    QFETCH(Vec3, way);
    constexpr double radius = 0.46;
    Sculptor sculptor(mesh_asserts::sculptable(model));
    drag(sculptor, Tool::Grab, radius, line(start, start + way, 0.05 * radius));
    const core::MeshReport report = judged(sculptor);
    QVERIFY(report.printReady());
    QVERIFY2(report.genus.value() == 0 && report.components == 1,
             qPrintable(QStringLiteral("genus %1, components %2").arg(report.genus.value()).arg(report.components)));
    const core::Mesh& mesh = sculptor.mesh();
    const double longest = 1.5 * core::edgeBounds(radius, 1).detail;
    for (core::Slot e = 0; e < mesh.slots().edges; ++e) {
        if (!mesh.isEdge(e))
            continue;
        const Vec3 a = mesh.point(mesh.to(2 * e)).cast<double>(), b = mesh.point(mesh.to(2 * e + 1)).cast<double>();
        const Vec3 middle = 0.5 * (a + b) - start;
        const double share = std::clamp(middle.dot(way) / way.squaredNorm(), 0.0, 1.0);
        if ((middle - share * way).norm() < 0.9 * radius)
            QVERIFY2((a - b).norm() <= longest, qPrintable(QString::number((a - b).norm() / longest)));
    }
}

void TestJoints::grabAlongTheSurface_leavesNoTeeth_data()
{
    QTest::addColumn<core::TriangleMesh>("model");
    QTest::addColumn<Vec3>("start");
    QTest::addColumn<Vec3>("way");
    QTest::addColumn<double>("radius");
    QTest::addColumn<core::Symmetry>("symmetry");
    for (const double radii : {0.5, 1.0}) {
        QTest::addRow("ball, %g radii", radii)
            << core::icosphere(5, 1) << Vec3(0, 0, 1) << Vec3(0, 0.46 * radii, 0) << 0.46 << core::Symmetry::None;
        QTest::addRow("fine ball, %g radii", radii)
            << core::icosphere(6, 1) << Vec3(0, 0, 1) << Vec3(0.12 * radii, 0.16 * radii, 0) << 0.2
            << core::Symmetry::None;
    }
    for (const double radii : {0.5, 1.0}) {
        QTest::addRow("ball, in the mirror plane, %g radii", radii)
            << core::icosphere(5, 1) << Vec3(0, 0, 1) << Vec3(0, 0.3 * radii, 0) << 0.3 << core::Symmetry::X;
    }
    for (const double radii : {0.5, 1.0, 2.0, 4.0})
        QTest::addRow("plate, %g radii", radii) << clay::slab(5, 0.5, 50) << Vec3(0.1, 0.25, 1)
                                                << Vec3(0, 0, -0.46 * radii) << 0.46 << core::Symmetry::None;
}

/// A drag along the surface pushes what lies before it. It must go all its way, and where it leaves an edge sharper
/// than 60 degrees, the line of such edges must turn by less than 40 degrees at each vertex.
void TestJoints::grabAlongTheSurface_leavesNoTeeth()
{
    QFETCH(core::TriangleMesh, model);
    QFETCH(Vec3, start);
    QFETCH(Vec3, way);
    QFETCH(double, radius);
    QFETCH(core::Symmetry, symmetry);
    StrokeSettings settings;
    settings.tool = Tool::Grab;
    settings.radius = radius;
    settings.topology = core::Topology::Refine;
    settings.symmetry = symmetry;
    Sculptor sculptor(mesh_asserts::sculptable(model));
    bool isWhole = true;
    sculptor.setAfterDab([&](const core::DabReport& report) {
        isWhole = isWhole && report.isWhole() && report.outcome == core::DabOutcome::Committed;
    });
    drag(sculptor, settings, line(start, start + way, 0.05 * radius));
    QVERIFY(isWhole);
    const core::Mesh& mesh = sculptor.mesh();
    std::map<core::Slot, std::vector<core::Slot>> lines; // the other ends of each vertex's sharp edges
    for (core::Slot e = 0; e < mesh.slots().edges; ++e) {
        if (!mesh.isEdge(e))
            continue;
        const core::Slot a = mesh.to(2 * e), b = mesh.to(2 * e + 1);
        const Vec3 middle = 0.5 * (mesh.point(a) + mesh.point(b)).cast<double>();
        const double share = std::clamp((middle - start).dot(way) / way.squaredNorm(), 0.0, 1.0);
        const Vec3 left = core::faceNormal(mesh, mesh.face(2 * e)),
                   right = core::faceNormal(mesh, mesh.face(2 * e + 1));
        if ((middle - start - share * way).norm() > 1.3 * radius || left.dot(right) > 0.5 * left.norm() * right.norm())
            continue;
        lines[a].push_back(b);
        lines[b].push_back(a);
    }
    for (const auto& [v, ends] : lines) {
        if (ends.size() != 2)
            continue;
        const Vec3 in = (mesh.point(v) - mesh.point(ends[0])).cast<double>(),
                   out = (mesh.point(ends[1]) - mesh.point(v)).cast<double>();
        QVERIFY(in.dot(out) > std::cos(40 * M_PI / 180) * in.norm() * out.norm());
    }
}

void TestJoints::endsOfARing_joinInOneSeam_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<double>("radius");
    QTest::addRow("grab, 0.3") << Tool::Grab << 0.3;
    QTest::addRow("grab, 0.45") << Tool::Grab << 0.45;
    for (const double radius : {0.3, 0.45, 0.6})
        QTest::addRow("pull, %g", radius) << Tool::Pull << radius;
}

void TestJoints::endsOfARing_joinInOneSeam()
{
    QFETCH(Tool, tool);
    QFETCH(double, radius);
    Sculptor sculptor(mesh_asserts::sculptable(clay::cutRing(0.3)));
    drag(sculptor, tool, radius, line({1, 0.2, 0}, {1, -0.3, 0}, 0.02));
    const core::MeshReport report = judged(sculptor);
    QVERIFY(report.printReady());
    QVERIFY2(report.genus.value() == 1 && report.components == 1,
             qPrintable(QStringLiteral("genus %1, components %2").arg(report.genus.value()).arg(report.components)));
}

/// Random dabs with a displacement of 0.4 to 1 radii raise horns that meet. Few handles may remain, and 97 % of the
/// dabs reach what was asked; none goes farther.
void TestJoints::strongDabs_reachWhatWasAsked()
{
    Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(4, 1)));
    StrokeFuzzer random(3);
    int whole = 0;
    for (int i = 0; i < 400; ++i) {
        const core::Stroke pull = random.strongPull(sculptor.mesh());
        sculptor.beginStroke(pull.settings);
        const core::DabReport dab = sculptor.addSample(pull.samples.front()).front();
        sculptor.endStroke();
        whole += dab.isWhole();
        QVERIFY2(dab.reached < 1.0001 * dab.asked, qPrintable(QString::number(dab.reached / dab.asked)));
    }
    QVERIFY2(whole >= 388, qPrintable(QString::number(whole)));
    const core::MeshReport report = judged(sculptor);
    QVERIFY(report.printReady());
    QVERIFY2(report.genus.value() <= 12 && report.components <= 6,
             qPrintable(QStringLiteral("genus %1, components %2").arg(report.genus.value()).arg(report.components)));
}

FETTLE_TEST(TestJoints)
#include "tst_joints.moc"
