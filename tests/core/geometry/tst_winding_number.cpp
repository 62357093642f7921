#include "core/geometry/winding_number.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include "core/analysis/solid_interior.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace core;

namespace
{
std::vector<Vec3> placesOf(const TriangleMesh& mesh)
{
    std::vector<Vec3> places;
    for (const Vec3f& p : mesh.points)
        places.push_back(p.cast<double>());
    return places;
}

/// Returns the solid angle of a triangle seen from the origin (van Oosterom and Strackee 1983).
double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}
/// Returns whether the origin is so far from the triangle that a dipole may stand for it.
bool isFar(const std::array<Vec3, 3>& corners)
{
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
    const auto reach = [&](const Vec3& corner) { return (corner - middle).norm(); };
    return middle.norm() > 2.9 * std::max({reach(corners[0]), reach(corners[1]), reach(corners[2])});
}
} // namespace

class TestWindingNumber : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fewTriangles_areSummedExactly();
    void dipoles_areAccurate();
    void shellsAroundAPoint_areCounted_data();
    void shellsAroundAPoint_areCounted();
};

/// Tests random triangles around the origin, too near for the dipole approximation. The planes of some contain the
/// origin.
void TestWindingNumber::fewTriangles_areSummedExactly()
{
    StrokeFuzzer random(11);
    for (int round = 0; round < 2000; ++round) {
        std::vector<Vec3> points;
        std::vector<Triangle> triangles;
        const Slot count = 1 + static_cast<Slot>(round % 8);
        double expected = 0;
        for (Slot f = 0; f < count; ++f) {
            std::array<Vec3, 3> corners;
            do {
                for (Vec3& corner : corners)
                    corner = random.uniform(0.1, 1) * random.direction();
                if (f % 4 == 3)
                    corners[2] = corners[0] + corners[1]; // the plane contains the origin, the triangle does not
            } while (isFar(corners));
            points.insert(points.end(), corners.begin(), corners.end());
            triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
            expected += solidAngle(corners[0], corners[1], corners[2]) / (4 * std::numbers::pi);
        }
        const double found = WindingNumber(points, triangles).at(Vec3::Zero());
        QVERIFY2(std::abs(found - expected) < 1e-9,
                 qPrintable(QStringLiteral("round %1: %2, not %3").arg(round).arg(found).arg(expected)));
    }
}

/// Tests points in and around a torus, where most faces are in dipoles: the winding number is nearly 0 or 1.
void TestWindingNumber::dipoles_areAccurate()
{
    const TriangleMesh torus = shapes::torus({.around = 120, .across = 60});
    const WindingNumber winding(placesOf(torus), torus.triangles);
    const SolidInterior interior(torus);
    StrokeFuzzer random(7);
    constexpr int count = 10'000;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3 p = random.uniform(0, 5) * random.direction();
        const double error = std::abs(winding.at(p) - (interior.contains(p) ? 1 : 0));
        QVERIFY2(error < 0.05, qPrintable(QStringLiteral("point %1: %2").arg(i).arg(error)));
        sum += error;
    }
    QVERIFY(sum / count < 0.01);
}

void TestWindingNumber::shellsAroundAPoint_areCounted_data()
{
    QTest::addColumn<int>("outward");
    QTest::addColumn<int>("inward");
    for (const auto& [outward, inward] : {std::pair(1, 0), {0, 1}, {7, 0}, {0, 7}, {5, 5}, {40, 3}})
        QTest::addRow("%d outwards, %d inwards", outward, inward) << outward << inward;
}

void TestWindingNumber::shellsAroundAPoint_areCounted()
{
    QFETCH(const int, outward);
    QFETCH(const int, inward);
    TriangleMesh all;
    for (int i = 0; i < outward + inward; ++i) {
        const TriangleMesh ball = shapes::scaled(shapes::cube(1), 1 + 0.01F * static_cast<float>(i));
        all = shapes::together(all, i < outward ? ball : shapes::reversed(ball));
    }
    const WindingNumber winding(placesOf(all), all.triangles);
    const Vec3 inside(0.3, 0.31, 0.32);
    QVERIFY(std::abs(winding.at(inside) - (outward - inward)) < 1e-6);
    QVERIFY(std::abs(winding.at(inside + Vec3(9, 2, 1))) < 0.02);
}

FETTLE_TEST(TestWindingNumber)
#include "tst_winding_number.moc"
