#include "core/geometry/lattice.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <random>

using core::Lattice;
using core::Vec3;
using core::Vec3f;

class TestLattice : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void forExtent_isTheFinestThatHoldsEightTimesTheModel();
    void forExtent_ofATenCentimetreBall();
    void snap_takesTheNearestPointAndTiesToEven();
    void randomLatticePoints_comeBack();
    void isOnLattice_refusesWhatLiesBetweenOrOutside();
};

void TestLattice::forExtent_isTheFinestThatHoldsEightTimesTheModel()
{
    std::mt19937 engine(20240812);
    std::uniform_real_distribution<double> mantissa(1, 2);
    for (int i = 0; i < 10'000; ++i) {
        const int exponent = static_cast<int>(engine() % 80) - 40;
        const double extent = std::ldexp(i % 10 == 0 ? 1.0 : mantissa(engine), exponent);
        const Lattice lattice = Lattice::forExtent(extent);
        QVERIFY(8 * extent <= lattice.halfVolume());
        QVERIFY(8 * extent > Lattice(lattice.exponent() + 1).halfVolume());
    }
}

void TestLattice::forExtent_ofATenCentimetreBall()
{
    const Lattice lattice = Lattice::forExtent(50);
    QCOMPARE(lattice.exponent(), 14);
    QCOMPARE(lattice.halfVolume(), 512.0);
    QCOMPARE(lattice.minDetail(), 1024 * lattice.unit());
}

void TestLattice::snap_takesTheNearestPointAndTiesToEven()
{
    const Lattice lattice(3); // unit: 1/8
    QCOMPARE(lattice.snap(1.0 / 16), 0.0);
    QCOMPARE(lattice.snap(3.0 / 16), 2.0 / 8);
    QCOMPARE(lattice.snap(-1.0 / 16), 0.0);
    QCOMPARE(lattice.snap(-3.0 / 16), -2.0 / 8);
    std::mt19937 engine(20240812);
    std::uniform_real_distribution<double> coordinate(-1e6, 1e6);
    for (int i = 0; i < 100'000; ++i) {
        const double x = coordinate(engine);
        QCOMPARE(lattice.snap(x), std::nearbyint(x * 8) / 8);
    }
    // snapping does not bring points beyond the limit onto the lattice
    QVERIFY(!lattice.contains(lattice.snap(Vec3(1e300, 0, 0)).cast<double>()));
}

void TestLattice::randomLatticePoints_comeBack()
{
    std::mt19937 engine(20240812);
    std::uniform_int_distribution<int> coordinate(-Lattice::limit, Lattice::limit);
    for (int k : {-20, 0, 14, 40}) {
        const Lattice lattice(k);
        for (int i = 0; i < 10'000; ++i) {
            const core::LatticePoint p(coordinate(engine), coordinate(engine), coordinate(engine));
            const Vec3f point = lattice.toPoint(p);
            QVERIFY(lattice.isOnLattice(point));
            QVERIFY(lattice.toLattice(point) == p);
            QVERIFY(lattice.snap(point.cast<double>()) == point);
            QVERIFY(lattice.contains(point.cast<double>()));
        }
    }
}

void TestLattice::isOnLattice_refusesWhatLiesBetweenOrOutside()
{
    const Lattice lattice(3);
    QVERIFY(lattice.isOnLattice({0.125f, -1, 7.5f}));
    QVERIFY(!lattice.isOnLattice({0.0625f, 0, 0}));
    const float wall = static_cast<float>(lattice.halfVolume());
    QVERIFY(lattice.isOnLattice({wall, -wall, wall}));
    QVERIFY(!lattice.isOnLattice({wall + 1, 0, 0}));
    QVERIFY(!lattice.isOnLattice({std::numeric_limits<float>::quiet_NaN(), 0, 0}));
    QVERIFY(!lattice.isOnLattice({0, std::numeric_limits<float>::infinity(), 0}));
}

FETTLE_TEST(TestLattice)
#include "tst_lattice.moc"
