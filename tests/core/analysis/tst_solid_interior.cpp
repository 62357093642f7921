#include "core/analysis/solid_interior.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include "core/mesh/mesh_builder.h"

#include <QTest>

using namespace core;

class TestSolidInterior : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void shellsInEachOther_alternate();
    void raysThroughVerticesAndEdges_areCountedOnce();
};

/// Tests random points against three balls in each other: solid, void, solid.
void TestSolidInterior::shellsInEachOther_alternate()
{
    const TriangleMesh solid =
        shapes::together(shapes::together(icosphere(4, 3), shapes::reversed(icosphere(3, 2))), icosphere(4, 1));
    const SolidInterior interior(solid);
    StrokeFuzzer random(5);
    int inside = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double distance = random.uniform(0, 4);
        const Vec3 p = distance * random.direction();
        const double gap = std::min({std::abs(distance - 1), std::abs(distance - 2), std::abs(distance - 3)});
        if (gap < 0.02) // between a ball and its triangles
            continue;
        const bool isInside = distance < 1 || (distance > 2 && distance < 3);
        inside += isInside ? 1 : 0;
        QVERIFY2(interior.contains(p) == isInside, qPrintable(QStringLiteral("at distance %1").arg(distance)));
    }
    QVERIFY(inside > 5000);
}

/// Tests a grid of points straight below the vertices, edges and diagonals of blocks.
void TestSolidInterior::raysThroughVerticesAndEdges_areCountedOnce()
{
    const TriangleMesh solid = shapes::together(shapes::cube(1), shapes::moved(shapes::cube(1), Vec3f(0, 0, 3)));
    const SolidInterior interior(solid);
    Box box;
    for (const Vec3f& p : shapes::cube(1).points)
        box.extend(p.cast<double>());
    int inside = 0;
    for (int i = -1; i <= 9; ++i) {
        for (int j = -1; j <= 9; ++j) {
            for (const double height : {-0.25, 0.125, 0.5, 0.875, 1.5, 2.75, 4.25}) {
                const Eigen::Array3d part(i / 8.0, j / 8.0, height);
                const Vec3 p = box.min() + (part * box.sizes().array()).matrix();
                const bool isAtBorder = i == 0 || j == 0 || i == 8 || j == 8;
                const bool isInside = i > 0 && j > 0 && i < 8 && j < 8 && height > 0 && height < 1;
                inside += isInside ? 1 : 0;
                if (!isAtBorder)
                    QCOMPARE(interior.contains(p), isInside);
            }
        }
    }
    QCOMPARE(inside, 7 * 7 * 3);
}

FETTLE_TEST(TestSolidInterior)
#include "tst_solid_interior.moc"
