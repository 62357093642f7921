// Tests that parts are united exactly if they do not bound a solid together.

#include "core/analysis/mesh_check.h"
#include "core/operations/part_union.h"
#include "core/parts/part_split.h"
#include "tests/support/cgal_judge.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

using core::PartUnion;
using core::TriangleMesh;
using core::Vec3f;

namespace
{
/// Returns two cubes of side 2 whose positions differ by this vector, as parts.
TriangleMesh twoCubes(const Vec3f& apart)
{
    return core::joined({{0, shapes::cube(2), {}, {}}, {7, shapes::moved(shapes::cube(2), apart), {}, {}}});
}
} // namespace

class TestPartUnion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void parts_areUnitedIfTheyMeet_data();
    void parts_areUnitedIfTheyMeet();
    void parts_thatAreApartStayAsTheyAre();
    void onePart_needsNoUnion();
    void cancelledUnion_changesNothing();
};

void TestPartUnion::parts_areUnitedIfTheyMeet_data()
{
    QTest::addColumn<float>("x");
    QTest::addColumn<float>("y");
    QTest::addColumn<double>("volume");
    QTest::newRow("overlap") << 1.0F << 1.0F << 14.0;
    QTest::newRow("shared face") << 2.0F << 0.0F << 16.0;
    QTest::newRow("part of a face") << 2.0F << 1.0F << 16.0;
    QTest::newRow("same place") << 0.0F << 0.0F << 8.0;
}

void TestPartUnion::parts_areUnitedIfTheyMeet()
{
    QFETCH(float, x);
    QFETCH(float, y);
    QFETCH(double, volume);
    for (const bool hasLattice : {false, true}) {
        TriangleMesh mesh = twoCubes({x, y, 0});
        const auto lattice = hasLattice ? std::optional(core::Lattice(14)) : std::nullopt;
        QCOMPARE(int(core::uniteParts(mesh, lattice)), int(PartUnion::Done));
        QVERIFY(mesh.parts.empty());
        const core::MeshReport report = core::checkMesh(mesh);
        QVERIFY(report.printReady() && judgedByCgal(mesh)->allWell());
        QCOMPARE(report.components, std::size_t(1));
        QVERIFY(std::abs(*report.volume - volume) < 1e-6);
    }
}

void TestPartUnion::parts_thatAreApartStayAsTheyAre()
{
    for (const float distance : {2.5F, 100.0F}) {
        const TriangleMesh before = twoCubes({distance, 0, 0});
        TriangleMesh mesh = before;
        QCOMPARE(int(core::uniteParts(mesh, {})), int(PartUnion::NotNeeded));
        QVERIFY(mesh.points == before.points && mesh.triangles == before.triangles && mesh.parts == before.parts);
    }
}

void TestPartUnion::onePart_needsNoUnion()
{
    TriangleMesh mesh = shapes::cube(2);
    QCOMPARE(int(core::uniteParts(mesh, {})), int(PartUnion::NotNeeded));
    QCOMPARE(mesh.triangles.size(), std::size_t(12));
}

void TestPartUnion::cancelledUnion_changesNothing()
{
    std::stop_source stop;
    double last = 0;
    const auto stopAtOnce = [&](double share) {
        last = share;
        stop.request_stop();
    };
    TriangleMesh mesh = twoCubes({1, 1, 0});
    core::uniteParts(mesh, {}, {stop.get_token(), stopAtOnce});
    QCOMPARE(mesh.triangles.size(), std::size_t(24));
    QVERIFY(last < 1);
}

FETTLE_TEST(TestPartUnion)
#include "tst_part_union.moc"
