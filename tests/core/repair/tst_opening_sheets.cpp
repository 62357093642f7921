#include "core/repair/repair.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

using namespace core;

namespace
{
constexpr float side = 40;
constexpr double volume = 64e3;

/// Returns a cube around the origin without its upper side, which is at z = 20.
TriangleMesh openCube()
{
    TriangleMesh mesh = shapes::cube(side);
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        return std::ranges::all_of(t, [&](Slot v) { return mesh.points[v].z() > 0; });
    });
    return mesh;
}

/// Returns a sheet of count x count squares that face upwards, at the height z, around (x, 0).
TriangleMesh sheet(Slot count, float length, float width, float z = side / 2, float x = 0)
{
    TriangleMesh mesh;
    for (Slot i = 0; i <= count; ++i)
        for (Slot k = 0; k <= count; ++k)
            mesh.points.emplace_back(x + length * (static_cast<float>(i) / static_cast<float>(count) - 0.5F),
                                     width * (static_cast<float>(k) / static_cast<float>(count) - 0.5F), z);
    for (Slot i = 0; i < count; ++i)
        for (Slot k = 0; k < count; ++k) {
            const Slot a = i * (count + 1) + k, b = a + count + 1;
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
        }
    return mesh;
}

TriangleMesh turned(TriangleMesh mesh, StrokeFuzzer& random)
{
    const Eigen::AngleAxisd turn(random.uniform(0, 3.1), random.direction());
    for (Vec3f& p : mesh.points)
        p = (turn * p.cast<double>()).cast<float>();
    return mesh;
}
} // namespace

class TestOpeningSheets : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void sheetsOnOpenings_areLeftOut_data();
    void sheetsOnOpenings_areLeftOut();
    void sheetsBesideOpenings_areTold_data();
    void sheetsBesideOpenings_areTold();
};

void TestOpeningSheets::sheetsOnOpenings_areLeftOut_data()
{
    QTest::addColumn<TriangleMesh>("sheets");
    for (const Slot count : {1U, 7U}) {
        QTest::addRow("larger, %u squares", count) << sheet(count, 46, 50);
        QTest::addRow("larger and reversed, %u squares", count) << shapes::reversed(sheet(count, 46, 50));
        QTest::addRow("half, %u squares", count) << sheet(count, side / 2, side, side / 2, side / 4);
        QTest::addRow("smaller, %u squares", count) << sheet(count, 30, 24);
        QTest::addRow("beyond one side, %u squares", count) << sheet(count, side, 30, side / 2, 9);
        QTest::addRow("two, %u squares", count) << shapes::together(sheet(count, 46, 50), sheet(count + 1, 60, 41));
    }
}

/// A cube lacks a side, and sheets that are not joined to it lie in the plane of that side. The result is the cube, at
/// any angle.
void TestOpeningSheets::sheetsOnOpenings_areLeftOut()
{
    QFETCH(TriangleMesh, sheets);
    const TriangleMesh model = shapes::together(openCube(), sheets);
    for (unsigned seed = 1; seed <= 8; ++seed) {
        StrokeFuzzer random(seed);
        const RepairResult result = repairMesh(turned(model, random));
        const QByteArray where = "seed " + QByteArray::number(seed);
        QVERIFY2(result.mesh && result.report.isFaithful(), where);
        const MeshReport report = checkMesh(*result.mesh);
        QVERIFY2(report.components == 1 && report.genus == 0, where);
        QVERIFY2(std::abs(*report.volume / volume - 1) < 1e-3, where);
    }
}

void TestOpeningSheets::sheetsBesideOpenings_areTold_data()
{
    QTest::addColumn<TriangleMesh>("sheets");
    QTest::addRow("above") << sheet(3, 46, 46, side / 2 + 2);
    TriangleMesh roof = sheet(2, 46, 46);
    roof.points[4].z() += 6;
    QTest::addRow("a roof") << roof;
}

/// The space between the opening and the sheet is lost, which is no faithful repair.
void TestOpeningSheets::sheetsBesideOpenings_areTold()
{
    QFETCH(TriangleMesh, sheets);
    const TriangleMesh model = shapes::together(openCube(), sheets);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        StrokeFuzzer random(seed);
        const RepairResult result = repairMesh(turned(model, random));
        const QByteArray where = "seed " + QByteArray::number(seed);
        QVERIFY2(!result.mesh || !result.report.isFaithful() || *checkMesh(*result.mesh).volume > 1.02 * volume, where);
    }
}

FETTLE_TEST(TestOpeningSheets)
#include "tst_opening_sheets.moc"
