#include "core/geometry/proximity_grid.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <random>
#include <set>

using core::Vec3;

class TestProximityGrid : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cells_holdAllInTheBox_data();
    void cells_holdAllInTheBox();
};

void TestProximityGrid::cells_holdAllInTheBox_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("reach");
    for (const int count : {0, 1, 50, 5000}) {
        for (const double reach : {0.001, 0.1, 0.5, 3.0})
            QTest::addRow("%d points, reach %g", count, reach) << count << reach;
    }
}

/// Checks that each point of a box is visited once, and that visited points are in cells that meet the box. Cells are
/// at most two reaches wide.
void TestProximityGrid::cells_holdAllInTheBox()
{
    QFETCH(int, count);
    QFETCH(double, reach);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const auto point = [&] { return Vec3(coordinate(random), coordinate(random), 0.1 * coordinate(random)); };
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
        points.push_back(point());
    const core::ProximityGrid grid(points, reach);
    for (int i = 0; i < 50; ++i) {
        const Vec3 middle = point(), half = reach * point().cwiseAbs();
        const core::Box box(middle - half, middle + half);
        std::set<core::Slot> visited;
        grid.forEachCellIn(box, [&](core::Slot cell) {
            for (const core::Slot p : grid.pointsIn(cell)) {
                QVERIFY(visited.insert(p).second);
                QVERIFY(box.exteriorDistance(points[p]) <= 2 * reach * std::sqrt(3));
            }
        });
        for (core::Slot p = 0; p < points.size(); ++p)
            QVERIFY(!box.contains(points[p]) || visited.contains(p));
    }
}

FETTLE_TEST(TestProximityGrid, QCoreApplication)
#include "tst_proximity_grid.moc"
