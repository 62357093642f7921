// Tests the sharp edges and the curvature that viewers receive for each vertex.
#include "core/mesh/dirty_slots.h"
#include "core/mesh/draw_vertex.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/sharp_shapes.h"
#include "tests/support/test_main.h"
#include "tests/support/viewer.h"

#include <QTest>

using core::DrawVertex;
using core::Slot;
using core::Vec3;
using mesh_asserts::sculptable;

namespace
{
Vec3 creaseOf(const DrawVertex& vertex)
{
    return Vec3(vertex.crease[0], vertex.crease[1], vertex.crease[2]) / 127;
}

/// Returns a long prism along z whose two upper sides enclose `degrees` at the ridge.
core::TriangleMesh roof(double degrees)
{
    const double half = degrees / 2 * std::numbers::pi / 180;
    core::TriangleMesh mesh = gridBox({10, 1, 40}, 8);
    for (core::Vec3f& p : mesh.points) {
        const auto top = static_cast<float>(-std::tan(half) * std::abs(p.x()));
        p.y() = -20 + (top + 20) * (p.y() + 1) / 2;
    }
    return mesh;
}
} // namespace

class TestDrawVertex : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void box_isSharpAlongItsEdgesOnly();
    void edge_isSharpFrom45Degrees_data();
    void edge_isSharpFrom45Degrees();
    void roundSolid_isSharpAlongItsRims();
    void coarseBall_isSmooth_data();
    void coarseBall_isSmooth();
    void curvature_tellsRidgesFromValleys();
    void curvature_isTheSameOnAFinerMesh();
    void crease_comesAndGoesWithTheStroke();
};

void TestDrawVertex::box_isSharpAlongItsEdgesOnly()
{
    const auto mesh = sculptable(gridBox({30, 20, 10}, 6));
    int corners = 0, onEdges = 0, onSides = 0;
    for (const Slot v : mesh->vertices()) {
        const DrawVertex vertex = core::drawVertex(*mesh, v);
        const core::Vec3f away = vertex.position.cwiseAbs() - core::Vec3f(30, 20, 10);
        const auto ends = (away.array().abs() < 1e-3F).count();
        QCOMPARE(vertex.crease[3], std::int8_t(ends > 1 ? 127 : 0));
        const Vec3 line = creaseOf(vertex);
        QCOMPARE(line.norm() > 0.5, ends == 2);
        if (ends == 2) // on an edge of the box; the crease is parallel to that edge
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                QCOMPARE(std::abs(line[axis]) > 0.99, std::abs(away[axis]) > 1e-3F);
        corners += ends == 3;
        onEdges += ends == 2;
        onSides += ends == 1;
    }
    QCOMPARE(corners, 8);
    QVERIFY(onEdges > 40 && onSides > 100);
}

void TestDrawVertex::edge_isSharpFrom45Degrees_data()
{
    QTest::addColumn<double>("degrees");
    QTest::addColumn<int>("least");
    QTest::addColumn<int>("most");
    QTest::newRow("30") << 30.0 << 0 << 0;
    QTest::newRow("37") << 37.0 << 0 << 0;
    QTest::newRow("42") << 42.0 << 20 << 110;
    QTest::newRow("45.5") << 45.5 << 127 << 127;
    QTest::newRow("90") << 90.0 << 127 << 127;
}

void TestDrawVertex::edge_isSharpFrom45Degrees()
{
    QFETCH(double, degrees);
    QFETCH(int, least);
    QFETCH(int, most);
    const auto mesh = sculptable(roof(degrees));
    int seen = 0;
    for (const Slot v : mesh->vertices()) {
        const DrawVertex vertex = core::drawVertex(*mesh, v);
        if (vertex.position.x() != 0 || vertex.position.y() < -1 || std::abs(vertex.position.z()) > 39)
            continue;
        ++seen;
        QVERIFY(vertex.crease[3] >= least && vertex.crease[3] <= most);
    }
    QVERIFY(seen >= 6);
}

/// The two rims of a cylinder are sharp, and each crease follows its circle. Its sides are smooth: they bend by 15
/// degrees from face to face.
void TestDrawVertex::roundSolid_isSharpAlongItsRims()
{
    const auto mesh = sculptable(turned({{0, -20}, {10, -20}, {20, -20}, {20, 0}, {20, 20}, {10, 20}, {0, 20}}, 24));
    int onRims = 0;
    for (const Slot v : mesh->vertices()) {
        const DrawVertex vertex = core::drawVertex(*mesh, v);
        const Vec3 out(vertex.position.x(), 0, vertex.position.z());
        const bool isOnRim = out.norm() > 19 && std::abs(vertex.position.y()) > 19;
        QCOMPARE(vertex.crease[3], std::int8_t(isOnRim ? 127 : 0));
        if (!isOnRim)
            continue;
        ++onRims;
        QVERIFY(std::abs(creaseOf(vertex).dot(Vec3::UnitY().cross(out).normalized())) > 0.98);
    }
    QCOMPARE(onRims, 48);
}

void TestDrawVertex::coarseBall_isSmooth_data()
{
    QTest::addColumn<int>("subdivisions");
    for (const int subdivisions : {1, 2, 3})
        QTest::addRow("%d", subdivisions) << subdivisions;
}

void TestDrawVertex::coarseBall_isSmooth()
{
    QFETCH(int, subdivisions);
    const auto mesh = sculptable(core::icosphere(subdivisions, 50));
    for (const Slot v : mesh->vertices())
        QCOMPARE(core::drawVertex(*mesh, v).crease, (std::array<std::int8_t, 4>{}));
}

/// Tests a cylinder with a groove around it.
void TestDrawVertex::curvature_tellsRidgesFromValleys()
{
    const auto mesh = sculptable(
        turned({{0, -20}, {36, -20}, {40, -20}, {40, -5}, {36, 0}, {40, 5}, {40, 20}, {36, 20}, {0, 20}}, 96));
    int ridges = 0, valleys = 0;
    for (const Slot v : mesh->vertices()) {
        const DrawVertex vertex = core::drawVertex(*mesh, v);
        const double height = std::abs(vertex.position.y()),
                     radius = std::hypot(vertex.position.x(), vertex.position.z());
        if (height > 19 && radius > 39) {
            ++ridges;
            QVERIFY(vertex.color[3] > DrawVertex::flat + 20);
        }
        if (height < 1 && radius < 37) {
            ++valleys;
            QVERIFY(vertex.color[3] < DrawVertex::flat - 10);
        }
    }
    QCOMPARE(ridges, 192);
    QCOMPARE(valleys, 96);
    const auto box = sculptable(gridBox({30, 30, 30}, 6));
    for (const Slot v : box->vertices()) {
        const DrawVertex vertex = core::drawVertex(*box, v);
        const bool isOnSide = vertex.crease[3] == 0;
        QCOMPARE(vertex.color[3] == DrawVertex::flat, isOnSide);
    }
}

/// Curvature depends on the surface, not on its triangles: balls of any resolution have the same one.
void TestDrawVertex::curvature_isTheSameOnAFinerMesh()
{
    int least = 255, most = 0;
    for (const int subdivisions : {2, 4, 6}) {
        const auto mesh = sculptable(core::icosphere(subdivisions, 50));
        for (const Slot v : mesh->vertices()) {
            const int curvature = core::drawVertex(*mesh, v).color[3];
            least = std::min(least, curvature);
            most = std::max(most, curvature);
        }
    }
    QVERIFY(least > DrawVertex::flat);
    QVERIFY(most - least <= 1);
}

/// A stamp leaves a sharp rim. After it and after its undo, the patches must contain the creases of the mesh.
void TestDrawVertex::crease_comesAndGoesWithTheStroke()
{
    core::Sculptor sculptor(sculptable(core::icosphere(3, 50)));
    Viewer viewer = viewerOf(sculptor.wholePatch());
    sculptor.takePatch();
    const auto creases = [&] {
        return std::ranges::count_if(viewer.vertices, [](const DrawVertex& v) { return v.crease[3] == 127; });
    };
    QCOMPARE(creases(), 0);
    core::StrokeSettings settings;
    settings.tool = core::Tool::Stamp;
    settings.radius = 12;
    sculptor.beginStroke(settings);
    core::StrokeSample sample;
    sample.position = {0, 50, 0};
    sculptor.addSample(sample);
    core::MeshDelta delta = sculptor.endStroke();
    viewer.apply(sculptor.takePatch());
    QVERIFY(viewer == viewerOf(sculptor.wholePatch()));
    QVERIFY(creases() > 0);
    sculptor.swap(delta);
    viewer.apply(sculptor.takePatch());
    QVERIFY(viewer == viewerOf(sculptor.wholePatch()));
    QCOMPARE(creases(), 0);
}

FETTLE_TEST(TestDrawVertex)
#include "tst_draw_vertex.moc"
