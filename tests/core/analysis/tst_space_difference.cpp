#include "core/analysis/space_difference.h"
#include "core/geometry/face_geometry.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>

using namespace core;

namespace
{
double differing(const TriangleMesh& faces, const TriangleMesh& solid)
{
    const SpaceDifference difference = spaceDifferences(faces, solid).eitherWay;
    return difference.lost + difference.gained;
}
} // namespace

class TestSpaceDifference : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSameSpace_differsByNothing();
    void otherSpace_isItsShare_data();
    void otherSpace_isItsShare();
    void openFaces_areClosedInThought();
    void stopped_endsAtOnce();
};

void TestSpaceDifference::theSameSpace_differsByNothing()
{
    const TriangleMesh ball = icosphere(3, 10), cavity = shapes::nestedSpheres(true);
    QCOMPARE(differing(ball, ball), 0.0);
    QCOMPARE(differing(shapes::reversed(ball), ball), 0.0);
    QCOMPARE(differing(cavity, cavity), 0.0);
    QCOMPARE(differing(shapes::together(ball, ball), ball), 0.0);
}

void TestSpaceDifference::otherSpace_isItsShare_data()
{
    QTest::addColumn<double>("side");
    for (const double side : {0.5, 0.9, 0.97, 1.03, 2.0})
        QTest::addRow("side %g", side) << side;
}

/// Compares a cube with a smaller or larger cube of the same centre.
void TestSpaceDifference::otherSpace_isItsShare()
{
    QFETCH(const double, side);
    const TriangleMesh unit = shapes::cube(1);
    const Vec3 middle = boxOf(unit).center();
    TriangleMesh other = unit;
    for (Vec3f& p : other.points)
        p = (middle + side * (p.cast<double>() - middle)).cast<float>();
    const double expected = 1 - std::pow(std::min(side, 1 / side), 3);
    const SpaceDifference difference = spaceDifferences(unit, other).eitherWay;
    QVERIFY(side < 1 ? difference.gained == 0 : difference.lost == 0);
    const double found = difference.lost + difference.gained;
    QVERIFY2(std::abs(found - expected) < 0.01, qPrintable(QStringLiteral("%1, not %2").arg(found).arg(expected)));
    QVERIFY(std::abs(differing(other, unit) - found) < 0.01);
    QCOMPARE(differing(shapes::moved(unit, {3, 3, 3}), unit), 1.0);
}

/// Checks that a cube with one side missing counts as closed, and that a flat sheet encloses nothing.
void TestSpaceDifference::openFaces_areClosedInThought()
{
    const TriangleMesh cube = shapes::cube(1);
    TriangleMesh open = cube, sheet = cube;
    const float top = static_cast<float>(boxOf(cube).max().y());
    const auto isOfTop = [&](const Triangle& t) {
        return std::ranges::all_of(t, [&](Slot v) { return cube.points[v].y() == top; });
    };
    std::erase_if(open.triangles, isOfTop);
    std::erase_if(sheet.triangles, [&](const Triangle& t) { return !isOfTop(t); });
    QVERIFY(open.triangles.size() < cube.triangles.size() && !sheet.triangles.empty());
    QVERIFY(differing(open, cube) < 0.005);
    QVERIFY(spaceDifferences(sheet, cube).eitherWay.gained > 0.99);
}

void TestSpaceDifference::stopped_endsAtOnce()
{
    std::stop_source source;
    source.request_stop();
    bool wasTold = false;
    const TriangleMesh ball = icosphere(3, 10);
    spaceDifferences(ball, ball, {source.get_token(), [&](double) { wasTold = true; }});
    QVERIFY(!wasTold);
}

FETTLE_TEST(TestSpaceDifference)
#include "tst_space_difference.moc"
