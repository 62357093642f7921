// Tests the rim of a stamped area: it follows the curve in which the stamp's surface intersects the model.
#include "core/mesh/surface_query.h"
#include "core/primitives/starter_models.h"
#include "core/sculpt/dab_bounds.h"
#include "core/sculpt/deform/brush_model.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <map>
#include <numbers>

using core::Slot;
using core::StrokeSettings;
using core::Vec3;

namespace
{
constexpr double stampRadius = 12;

struct Rim
{
    std::map<Slot, std::vector<Slot>> neighbours; ///< neighbours of each vertex along the rim
    double length = 0;
};

/// Returns the edges between faces made by the stamp and other faces.
template <class Test> Rim rimOf(const core::Mesh& mesh, const Vec3& center, Test isOld)
{
    Rim rim;
    for (Slot e = 0; e < mesh.slots().edges; ++e) {
        if (!mesh.isEdge(e))
            continue;
        const Slot a = mesh.to(2 * e), b = mesh.to(2 * e + 1);
        const Vec3 p = mesh.point(a).cast<double>(), q = mesh.point(b).cast<double>();
        if ((p - center).norm() > 1.2 * stampRadius || isOld(mesh.face(2 * e)) == isOld(mesh.face(2 * e + 1)))
            continue;
        rim.neighbours[a].push_back(b);
        rim.neighbours[b].push_back(a);
        rim.length += (p - q).norm();
    }
    return rim;
}
} // namespace

class TestStampRim : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void followsTheCurve_data();
    void followsTheCurve();
    void again_changesLittle();
    void onFolds_isDoneWhole_data();
    void onFolds_isDoneWhole();
};

void TestStampRim::followsTheCurve_data()
{
    QTest::addColumn<core::TriangleMesh>("model");
    QTest::addColumn<Vec3>("center");
    QTest::addColumn<bool>("isCube");
    QTest::addColumn<bool>("raises");
    QTest::addColumn<double>("strength");
    for (const bool isCube : {false, true}) {
        for (const bool raises : {false, true}) {
            const std::vector all{1.0, 0.4};
            for (const double strength : byEffort(std::vector{isCube == raises ? 1.0 : 0.4}, all)) {
                const auto add = [&](const char* name, const core::TriangleMesh& model, const Vec3& center) {
                    QTest::addRow("%s, %s, %s, %g", name, isCube ? "cube" : "ball", raises ? "raised" : "pressed",
                                  strength)
                        << model << center << isCube << raises << strength;
                };
                add("ball", core::icosphere(5, 45), {0, 0, 45});
                add("coarse ball", core::icosphere(3, 45), {0, 0, 45});
                add("slab", clay::slab(80, 30, 24), {1.3, 15, 0.7});
            }
        }
    }
}

void TestStampRim::followsTheCurve()
{
    QFETCH(core::TriangleMesh, model);
    QFETCH(Vec3, center);
    QFETCH(bool, isCube);
    QFETCH(bool, raises);
    QFETCH(double, strength);
    const auto before = mesh_asserts::sculptable(model);
    core::Sculptor sculptor(mesh_asserts::sculptable(model));
    StrokeSettings settings;
    settings.tool = core::Tool::Stamp;
    settings.radius = stampRadius;
    settings.strength = strength;
    settings.inverted = raises;
    settings.topology = core::Topology::Refine;
    if (isCube)
        settings.model = core::BrushModel::of(core::starterModel(core::Starter::Cube), {}).model;
    QCOMPARE(clay::dabOnce(sculptor, settings, center).outcome, core::DabOutcome::Committed);
    QVERIFY(mesh_asserts::isSound(sculptor));

    const core::Mesh& mesh = sculptor.mesh();
    const double edge = core::dabBounds(settings, mesh, stampRadius).detail, half = stampRadius / std::sqrt(3.0);
    // axis of the stamp's up direction along the surface: y on the front of the ball, z on the slab
    const int up = center.y() == 0 ? 1 : 2;
    const auto off = [&](const Vec3& p) {
        const Vec3 r = p - center;
        return isCube ? std::max(std::abs(r.x()), std::abs(r[up])) - half : r.norm() - stampRadius;
    };
    const core::FaceOctree octree(*before);
    const auto point = [&](Slot v) { return Vec3(mesh.point(v).cast<double>()); };
    const auto isOnSurface = [&](Slot v) { return nearestPoint(*before, octree, point(v))->distance < 0.05 * edge; };
    const Rim rim = rimOf(mesh, center, [&](Slot f) {
        const auto [a, b, c] = mesh.corners(f);
        return off((point(a) + point(b) + point(c)) / 3) > 0 && isOnSurface(a) && isOnSurface(b) && isOnSurface(c);
    });
    for (const auto& [v, neighbours] : rim.neighbours) {
        QCOMPARE(neighbours.size(), std::size_t(2));
        QVERIFY2(std::abs(off(point(v))) < 0.5 * edge, qPrintable(QString::number(off(point(v)) / edge)));
        QVERIFY(isOnSurface(v));
        const Vec3 in = point(v) - point(neighbours[0]), out = point(neighbours[1]) - point(v);
        const Vec3 r = (point(v) - center).cwiseAbs();
        const bool isCorner = isCube && half - r.x() < edge && half - r[up] < edge;
        const bool isSharp = in.dot(out) < std::cos(std::numbers::pi * 40 / 180) * in.norm() * out.norm();
        QVERIFY(isCorner || !isSharp);
    }
    const double expected = isCube ? 8 * half : 2 * std::numbers::pi * stampRadius;
    QVERIFY2(std::abs(rim.length - expected) < 0.05 * expected, qPrintable(QString::number(rim.length)));
}

/// A second stamp at the same place must change almost nothing and must not leave an outline.
void TestStampRim::again_changesLittle()
{
    core::Sculptor sculptor(mesh_asserts::sculptable(clay::slab(120, 40, 40)));
    StrokeSettings settings;
    settings.tool = core::Tool::Stamp;
    settings.radius = 15;
    settings.topology = core::Topology::Refine;
    clay::dabOnce(sculptor, settings, {1, 20, 2});
    const core::SlotCounts once = sculptor.mesh().live();
    for (int i = 0; i < 3; ++i)
        clay::dabOnce(sculptor, settings, {1, 20, 2});
    QVERIFY(mesh_asserts::isSound(sculptor));
    QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()), 2);
    QVERIFY2(sculptor.mesh().live().faces < 1.1 * once.faces,
             qPrintable(QStringLiteral("%1 %2").arg(sculptor.mesh().live().faces).arg(once.faces)));
}

void TestStampRim::onFolds_isDoneWhole_data()
{
    QTest::addColumn<core::TriangleMesh>("model");
    QTest::addRow("bowl") << clay::bowl();
    QTest::addRow("spiral") << clay::spiral();
    QTest::addRow("fingers") << clay::twoFingers(0.05);
}

/// A stamp over several folds of the surface must have the same result as cutting out or adding its solid.
void TestStampRim::onFolds_isDoneWhole()
{
    QFETCH(core::TriangleMesh, model);
    for (std::size_t i = 0; i < 12; ++i) {
        core::Sculptor sculptor(mesh_asserts::sculptable(model));
        StrokeSettings settings;
        settings.tool = core::Tool::Stamp;
        settings.radius = 0.3;
        settings.inverted = i % 2 == 1;
        settings.topology = core::Topology::Refine;
        const Vec3 center = model.points[i * model.points.size() / 12].cast<double>();
        QCOMPARE(clay::dabOnce(sculptor, settings, center).outcome, core::DabOutcome::Committed);
        QVERIFY(mesh_asserts::isSound(sculptor));
        if (!settings.inverted) // nothing may remain inside the stamp
            QVERIFY(sculptor.nearest(center, 0.75 * settings.radius) == std::nullopt);
    }
}

FETTLE_TEST(TestStampRim)
#include "tst_stamp_rim.moc"
