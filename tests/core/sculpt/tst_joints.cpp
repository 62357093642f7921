// Tests the joints that fusion makes where surfaces meet: one seam, with no handle, tunnel or void beside it.
#include "core/analysis/mesh_check.h"
#include "core/mesh/mesh_builder.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <random>

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

/// Drags the brush in even steps, with one dab each.
void drag(Sculptor& sculptor, Tool tool, double radius, const std::vector<Vec3>& path)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = radius;
    settings.topology = core::Topology::Refine;
    sculptor.beginStroke(settings);
    for (const Vec3& place : path) {
        core::StrokeSample sample;
        sample.position = place;
        sculptor.addSample(sample);
    }
    sculptor.endStroke();
}

std::vector<Vec3> line(const Vec3& from, const Vec3& to, double step)
{
    const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step)));
    std::vector<Vec3> path;
    for (int i = 0; i <= count; ++i)
        path.push_back(from + double(i) / count * (to - from));
    return path;
}

/// The distances from the x axis at which the surface crosses the plane at x, one for each edge.
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
    void grabAlongTheSurface_staysInOnePiece_data();
    void grabAlongTheSurface_staysInOnePiece();
    void endsOfARing_joinInOneSeam_data();
    void endsOfARing_joinInOneSeam();
    void strongDabs_leaveFewHandles();
};

/// Over five radii its section has at least ten corners, and its radius falls by a third at most.
void TestJoints::snakeHook_isRound()
{
    constexpr double radius = 0.2;
    Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(4, 1)));
    drag(sculptor, Tool::SnakeHook, radius, line({1, 0, 0}, {1 + 6 * radius, 0, 0}, 0.1 * radius));
    double first = 0;
    for (double way = 0.5; way <= 5.5; way += 0.5) {
        const std::vector<double> distances = section(sculptor, 1 + way * radius);
        QVERIFY(distances.size() >= 20); // each corner has two edges or more
        const auto [least, most] = std::ranges::minmax(distances);
        QVERIFY2(least > 0.85 * most, qPrintable(QStringLiteral("%1 to %2").arg(least).arg(most)));
        first = std::max(first, most);
        QVERIFY2(least > 0.66 * first, qPrintable(QStringLiteral("%1 after %2").arg(least).arg(first)));
    }
    QVERIFY(mesh_asserts::badFaces(sculptor.mesh()).empty());
}

void TestJoints::grabAlongTheSurface_staysInOnePiece_data()
{
    QTest::addColumn<core::TriangleMesh>("model");
    QTest::addColumn<Vec3>("start");
    QTest::addColumn<Vec3>("way");
    for (const double radii : {0.5, 1.0, 2.0, 4.0})
        QTest::addRow("ball, %g radii", radii) << core::icosphere(5, 1) << Vec3(0, 0, 1) << Vec3(0, 0.46 * radii, 0);
    for (const double radii : {0.5, 1.0, 2.0})
        QTest::addRow("plate, %g radii", radii)
            << clay::slab(4, 0.5, 40) << Vec3(0.1, 0.25, 0.5) << Vec3(0, 0, -0.46 * radii);
}

/// A Grab along the surface leaves one part, however thin, with no edge longer than 1.5 d_detail.
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

/// Dabs at random places, each of 0.4 to 1 radii, raise horns that meet.
void TestJoints::strongDabs_leaveFewHandles()
{
    Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(4, 1)));
    std::mt19937_64 random(3);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    for (int i = 0; i < 400; ++i) {
        core::Slot v;
        do
            v = static_cast<core::Slot>(random() % sculptor.mesh().slots().vertices);
        while (!sculptor.mesh().isVertex(v));
        StrokeSettings settings;
        settings.radius = between(0.08, 0.3);
        settings.strength = between(4, 10);
        core::StrokeSample sample;
        sample.position = sculptor.mesh().point(v).cast<double>();
        sculptor.beginStroke(settings);
        sculptor.addSample(sample);
        sculptor.endStroke();
    }
    const core::MeshReport report = judged(sculptor);
    QVERIFY(report.printReady());
    QVERIFY2(report.genus.value() <= 12 && report.components <= 6,
             qPrintable(QStringLiteral("genus %1, components %2").arg(report.genus.value()).arg(report.components)));
}

FETTLE_TEST(TestJoints)
#include "tst_joints.moc"
