#include "core/repair/repair.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <array>
#include <cmath>
#include <random>
#include <utility>

using namespace core;

namespace
{
/// Returns a cube whose sides are divided into quads, each cut along one of its diagonals. `cuts`: number of quads
/// along each axis. Faces have no common vertices, except those of a quad.
TriangleMesh cutCube(float min, float max, const std::array<int, 3>& cuts, std::mt19937_64& random)
{
    TriangleMesh mesh;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto share = [&](int i, std::size_t along) {
            return min + (max - min) * static_cast<float>(i) / static_cast<float>(cuts[along]);
        };
        const auto addQuad = [&](int i, int j, bool isUpper) {
            const auto a = static_cast<Slot>(mesh.points.size()), b = a + 1, c = a + 2, d = a + 3;
            for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
                std::array<float, 3> p;
                p[axis] = isUpper ? max : min;
                p[u] = share(i + (isUpper ? x : y), u);
                p[v] = share(j + (isUpper ? y : x), v);
                mesh.points.emplace_back(p[0], p[1], p[2]);
            }
            const bool isOther = random() % 2 == 0;
            mesh.triangles.push_back({a, b, isOther ? d : c});
            mesh.triangles.push_back({isOther ? b : a, c, d});
        };
        for (const bool isUpper : {false, true})
            for (int i = 0; i < cuts[u]; ++i)
                for (int j = 0; j < cuts[v]; ++j)
                    addQuad(i, j, isUpper);
    }
    return mesh;
}

/// A cube of side 10 with a cavity of side 6. Cube and cavity each exist in several copies with different triangles.
struct Doubled
{
    int bodies, cavities, inserts = 0;    ///< numbers of copies; inserts fill the cavity exactly
    int openBodies = 0, openCavities = 0; ///< number of copies that lack one face
    float larger = 0;                     ///< excess length of the first body's sides
    bool isTurned = false;                ///< the first body faces inwards
};

TriangleMesh makeDoubled(const Doubled& parts, unsigned seed)
{
    std::mt19937_64 random(seed);
    TriangleMesh mesh;
    const auto add = [&](int copies, int openOnes, float min, float max, bool isCavity) {
        for (int i = 0; i < copies; ++i) {
            std::array<int, 3> cuts;
            for (int& cut : cuts)
                cut = random() % 3 == 0 ? 2 : 1;
            const bool isFirstBody = i == 0 && min == 0;
            TriangleMesh copy = cutCube(min, max + (isFirstBody ? parts.larger : 0), cuts, random);
            if (isFirstBody && parts.isTurned)
                copy = shapes::reversed(copy);
            if (i < openOnes)
                copy.triangles.erase(copy.triangles.begin() +
                                     static_cast<std::ptrdiff_t>(random() % copy.triangles.size()));
            mesh = shapes::together(mesh, isCavity ? shapes::reversed(copy) : copy);
        }
    };
    add(parts.bodies, parts.openBodies, 0, 10, false);
    add(parts.cavities, parts.openCavities, 2, 8, true);
    add(parts.inserts, 0, 2, 8, false);
    return mesh;
}

double volumeOf(const Doubled& parts)
{
    return parts.inserts > 0 ? 1000 : 784;
}
} // namespace

/// Tests solids whose bodies, cavities and inserts exist in several copies with different triangles.
class TestDoubledParts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wrongVolume_isTold_data();
    void wrongVolume_isTold();
};

void TestDoubledParts::wrongVolume_isTold_data()
{
    QTest::addColumn<Doubled>("parts");
    QTest::addRow("cavity three times") << Doubled{1, 3};
    QTest::addRow("cavity four times") << Doubled{1, 4};
    QTest::addRow("cavity twice, a face missing") << Doubled{1, 2, 0, 0, 1};
    QTest::addRow("hollow body twice, a face missing") << Doubled{2, 2, 0, 1, 0};
    QTest::addRow("body twice, a face missing") << Doubled{2, 1, 0, 1, 0};
    QTest::addRow("hollow body twice, a face of each copy missing") << Doubled{2, 2, 0, 2, 2};
    QTest::addRow("hollow body twice, one larger") << Doubled{2, 2, 0, 0, 0, 0.01F};
    QTest::addRow("body four times, one turned over") << Doubled{4, 1, 0, 0, 0, 0, true};
    QTest::addRow("insert") << Doubled{1, 1, 1};
    QTest::addRow("insert, a face missing") << Doubled{1, 1, 1, 1, 0};
    QTest::addRow("insert twice") << Doubled{1, 1, 2};
}

void TestDoubledParts::wrongVolume_isTold()
{
    QFETCH(const Doubled, parts);
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const RepairResult result = repairMesh(makeDoubled(parts, seed));
        QVERIFY2(!result.mesh || std::abs(result.report.after.volume / volumeOf(parts) - 1) < 0.02 ||
                     !result.report.isFaithful(),
                 qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(result.report.after.volume)));
    }
}

FETTLE_TEST(TestDoubledParts)
#include "tst_doubled_parts.moc"
