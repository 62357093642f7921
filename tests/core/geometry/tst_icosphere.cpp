#include "core/geometry/triangle_mesh.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <map>

class TestIcosphere : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void counts_data();
    void counts();
    void isClosedAndOutwards();
    void liesOnTheSphere();
};

void TestIcosphere::counts_data()
{
    QTest::addColumn<int>("subdivisions");
    QTest::addColumn<int>("vertices");
    QTest::newRow("icosahedron") << 0 << 12;
    QTest::newRow("the paper's sphere") << 4 << 2562;
    QTest::newRow("large") << 8 << 655362;
}

void TestIcosphere::counts()
{
    QFETCH(int, subdivisions);
    QFETCH(int, vertices);
    const core::TriangleMesh mesh = core::icosphere(subdivisions, 50);
    QCOMPARE(mesh.points.size(), static_cast<std::size_t>(vertices));
    QCOMPARE(mesh.triangles.size(), static_cast<std::size_t>(2 * vertices - 4)); // by Euler's formula V - E + F = 2
}

void TestIcosphere::isClosedAndOutwards()
{
    const core::TriangleMesh mesh = core::icosphere(3, 2);
    std::map<std::pair<core::Slot, core::Slot>, int> edges;
    for (const core::Triangle& t : mesh.triangles) {
        const core::Vec3f &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        QVERIFY((b - a).cross(c - a).dot(a) > 0);
        for (std::size_t i = 0; i < 3; ++i)
            ++edges[{t[i], t[(i + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
        QCOMPARE(count, 1);
        QVERIFY(edges.count({edge.second, edge.first}) == 1);
    }
}

void TestIcosphere::liesOnTheSphere()
{
    for (const core::Vec3f& p : core::icosphere(5, 50).points)
        QVERIFY(std::abs(p.cast<double>().norm() - 50) < 1e-5);
}

FETTLE_TEST(TestIcosphere)
#include "tst_icosphere.moc"
