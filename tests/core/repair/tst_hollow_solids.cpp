#include "core/analysis/mesh_check.h"
#include "core/repair/repair.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

using namespace core;

namespace
{
TriangleMesh box(const Vec3f& min, const Vec3f& max)
{
    TriangleMesh mesh = shapes::cube(2);
    Box old;
    for (const Vec3f& p : mesh.points)
        old.extend(p.cast<double>());
    for (Vec3f& p : mesh.points)
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = static_cast<double>(p[axis]) < old.center()[axis] ? min[axis] : max[axis];
    return mesh;
}

TriangleMesh hollow(const Vec3f& min, const Vec3f& max)
{
    return shapes::together(box(Vec3f::Zero(), Vec3f::Constant(10)), shapes::reversed(box(min, max)));
}

TriangleMesh turned(TriangleMesh mesh, StrokeFuzzer& random)
{
    const Eigen::AngleAxisd turn(random.uniform(0.1, 3), random.direction());
    for (Vec3f& p : mesh.points)
        p = (turn * p.cast<double>()).cast<float>();
    return mesh;
}

/// Returns the sides of a prism along z, without its ends.
TriangleMesh sides(Slot count, double radius, const Vec3& foot, double height)
{
    TriangleMesh mesh;
    for (Slot i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        for (const double z : {0.0, height})
            mesh.points.push_back((foot + Vec3(radius * std::cos(angle), radius * std::sin(angle), z)).cast<float>());
        const Slot a = 2 * i, b = 2 * ((i + 1) % count);
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
    }
    return mesh;
}

double areaOfPrism(Slot count, double radius)
{
    return count * radius * radius / 2 * std::sin(2 * std::numbers::pi / count);
}

/// Returns a box from the origin with cells x cells squares on each side, without the far sides in x and y.
TriangleMesh boxWithoutTwoSides(const Vec3f& size, int cells)
{
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool isFar : {false, true}) {
            if (isFar && axis != 2)
                continue;
            const int u = (axis + (isFar ? 1 : 2)) % 3, v = 3 - axis - u;
            for (int cell = 0; cell < cells * cells; ++cell) {
                const auto first = static_cast<Slot>(mesh.points.size());
                for (const auto& [i, k] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
                    Vec3f p = Vec3f::Zero();
                    p[axis] = isFar ? size[axis] : 0;
                    p[u] = size[u] * static_cast<float>(cell % cells + i) / static_cast<float>(cells);
                    p[v] = size[v] * static_cast<float>(cell / cells + k) / static_cast<float>(cells);
                    mesh.points.push_back(p);
                }
                mesh.triangles.push_back({first, first + 1, first + 2});
                mesh.triangles.push_back({first, first + 2, first + 3});
            }
        }
    return mesh;
}

/// Adds a face at an edge of the cavity. Its third corner is `corner`, which is in the hollow or in the wall.
TriangleMesh withStrayFace(TriangleMesh mesh, const Vec3f& corner)
{
    const Triangle last = mesh.triangles.back();
    mesh.points.push_back(corner);
    mesh.triangles.push_back({last[0], last[1], static_cast<Slot>(mesh.points.size() - 1)});
    return mesh;
}

/// Replaces the first face by one with a thin spike in its middle. The corners of the spike's foot are 0.0005 from its
/// axis.
TriangleMesh withNeedle(TriangleMesh mesh, double length = 2)
{
    const Triangle face = mesh.triangles[0];
    const auto at = [&](std::size_t i) { return mesh.points[face[i]].cast<double>(); };
    const Vec3 middle = (at(0) + at(1) + at(2)) / 3, normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    const auto foot = static_cast<Slot>(mesh.points.size()), tip = foot + 3;
    for (std::size_t i = 0; i < 3; ++i)
        mesh.points.push_back((middle + 5e-4 * (at(i) - middle).normalized()).cast<float>());
    mesh.points.push_back((middle + length * normal).cast<float>());
    mesh.triangles.erase(mesh.triangles.begin());
    for (Slot i = 0; i < 3; ++i) {
        const Slot next = (i + 1) % 3;
        mesh.triangles.push_back({face[i], face[next], foot + next});
        mesh.triangles.push_back({face[i], foot + next, foot + i});
        mesh.triangles.push_back({foot + i, foot + next, tip});
    }
    return mesh;
}

/// Returns a closed tube through rings with equal numbers of corners. Corners are counter-clockwise as seen from beyond
/// the last ring.
TriangleMesh tube(const std::vector<std::vector<Vec3f>>& rings)
{
    TriangleMesh mesh;
    for (const std::vector<Vec3f>& ring : rings)
        mesh.points.insert(mesh.points.end(), ring.begin(), ring.end());
    const auto sides = static_cast<Slot>(rings[0].size()), last = static_cast<Slot>(mesh.points.size()) - sides;
    for (Slot i = 0; i < sides; ++i) {
        const Slot next = (i + 1) % sides;
        for (Slot ring = 0; ring < last; ring += sides) {
            mesh.triangles.push_back({ring + i, ring + next, ring + sides + next});
            mesh.triangles.push_back({ring + i, ring + sides + next, ring + sides + i});
        }
        if (i > 0 && next > 0) {
            mesh.triangles.push_back({0, next, i});
            mesh.triangles.push_back({last, last + i, last + next});
        }
    }
    return mesh;
}

std::vector<Vec3f> octagon(double radius, double z)
{
    std::vector<Vec3f> ring;
    for (int i = 0; i < 8; ++i) {
        const double angle = std::numbers::pi * i / 4;
        ring.push_back(Vec3(5 + radius * std::cos(angle), 5 + radius * std::sin(angle), z).cast<float>());
    }
    return ring;
}

/// Replaces the diagonal of the tube's first quad by the other one.
TriangleMesh cutOtherwise(TriangleMesh mesh)
{
    const auto [a, b, c] = mesh.triangles[0];
    const Slot d = mesh.triangles[1][2];
    mesh.triangles[0] = {a, b, d};
    mesh.triangles[1] = {b, c, d};
    return mesh;
}

/// Returns a box with a cavity. Most faces of the cavity belong to a thin vent that leads outside.
TriangleMesh withVent()
{
    std::vector<std::vector<Vec3f>> rings{octagon(4, 1), octagon(4, 9)};
    for (int ring = 0; ring < 200; ++ring)
        rings.push_back(octagon(0.3, 9.001 + 5 * ring / 199.0));
    return shapes::together(box(Vec3f::Zero(), Vec3f::Constant(10)), shapes::reversed(tube(rings)));
}

/// Returns a block with a thin slot. Most of the part that cuts the slot is outside the block.
TriangleMesh withSlotCutter()
{
    const auto ring = [](float width, float z) {
        return std::vector<Vec3f>{{-8, -width, z}, {8, -width, z}, {8, width, z}, {-8, width, z}};
    };
    return shapes::together(box({-10, -10, -20}, {10, 10, -2}),
                            shapes::reversed(tube({ring(0.1F, -18), ring(0.1F, 0), ring(2, 4)})));
}

/// Returns a box with a cavity that a sheet divides into two halves. Every wall of the cavity has an edge with three
/// faces.
TriangleMesh hollowWithSheetAcross()
{
    const TriangleMesh left = box(Vec3f(3, 3, 3), Vec3f(5, 7, 7)), right = box(Vec3f(5, 3, 3), Vec3f(7, 7, 7));
    TriangleMesh halves = shapes::reversed(shapes::together(left, right));
    std::erase_if(halves.triangles, [&](const Triangle& t) {
        return std::ranges::all_of(t, [&](Slot v) { return v >= left.points.size() && halves.points[v].x() == 5; });
    });
    return shapes::together(box(Vec3f::Zero(), Vec3f::Constant(10)), halves);
}
} // namespace

/// Tests that voids stay empty, for different ways of modelling them and for rotated models.
class TestHollowSolids : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void volume_isKept_data();
    void volume_isKept();
    void cubesThatTouch_areTakenApart();
    void missingRims_areRings();
    void shortTubes_getLids();
    void openingOverAnEdge_isFilledToTheEdge();
    void openingInARoundSide_keepsTheBody();
};

void TestHollowSolids::volume_isKept_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<double>("volume");
    const TriangleMesh shell = hollow(Vec3f::Constant(3), Vec3f::Constant(7));
    QTest::addRow("hollow") << shell << 936.0;
    QTest::addRow("stray face in the hollow") << withStrayFace(shell, Vec3f(5.1F, 4.9F, 5.2F)) << 936.0;
    QTest::addRow("stray face in the wall") << withStrayFace(shell, Vec3f(8.1F, 8.2F, 8.3F)) << 936.0;
    QTest::addRow("sheet across the hollow") << hollowWithSheetAcross() << 936.0;
    QTest::addRow("inside out as a whole") << shapes::reversed(shell) << 936.0;
    QTest::addRow("with a core, inside out as a whole")
        << shapes::reversed(shapes::together(shell, box(Vec3f::Constant(4), Vec3f::Constant(6)))) << 944.0;
    for (const float end : {10.001F, 10.1F, 11.0F})
        QTest::addRow("cavity that breaks through by %g", static_cast<double>(end - 10))
            << hollow({3, 2, 2}, {end, 8, 8}) << 1000.0 - 7 * 36;
    QTest::addRow("bore that begins and ends outside") << hollow({2, 2, -1}, {8, 8, 11}) << 640.0;
    QTest::addRow("cavities that cross") << shapes::together(hollow({2, 2, 2}, {6, 6, 6}),
                                                             shapes::reversed(box({4, 4, 4}, {8, 8, 8})))
                                         << 1000.0 - 120;
    QTest::addRow("bores that cross") << shapes::together(hollow({-1, 2, 2}, {11, 8, 8}),
                                                          shapes::reversed(box({2, -1, 2}, {8, 11, 8})))
                                      << 1000.0 - 360 - 144;
    QTest::addRow("pin in a body that is inside out")
        << shapes::together(shapes::reversed(box(Vec3f::Zero(), Vec3f::Constant(10))), box({4, 4, 0.5F}, {6, 6, 10.2F}))
        << 1000.0 + 4 * 0.2;
    QTest::addRow("lump over the wall, inside out")
        << shapes::together(shell, shapes::reversed(box({6, 4, 4}, {14, 6, 6}))) << 936.0 + 4 + 16;
    QTest::addRow("lump over the wall, all else inside out")
        << shapes::together(shapes::reversed(shell), box({6, 4, 4}, {14, 6, 6})) << 936.0 + 4 + 16;
    QTest::addRow("hole through two faces") << hollow({3, 3, 0}, {7, 7, 10}) << 840.0;
    QTest::addRow("pocket") << hollow({3, 3, 5}, {7, 7, 10}) << 920.0;
    QTest::addRow("pipe") << hollow({1, 1, 0}, {9, 9, 10}) << 360.0;
    // The inner part faces outwards, so it is not a void.
    QTest::addRow("part in a part") << shapes::together(box(Vec3f::Zero(), Vec3f::Constant(10)),
                                                        box(Vec3f::Constant(3), Vec3f::Constant(7)))
                                    << 1000.0;
    QTest::addRow("parts that cross, one with a needle")
        << shapes::together(withNeedle(box(Vec3f::Zero(), Vec3f::Constant(10))),
                            box(Vec3f::Constant(5), Vec3f::Constant(15)))
        << 1875.0;
    QTest::addRow("core with a needle in a hollow")
        << shapes::together(shapes::together(hollow(Vec3f::Constant(0.5F), Vec3f::Constant(9.5F)),
                                             withNeedle(box(Vec3f::Constant(0.6F), Vec3f::Constant(9.4F)), 0.08)),
                            box({9.8F, 4, 4}, {11, 5, 5}))
        << 1000.0 - 729 + 681.472 + 1;
    QTest::addRow("insert that stands proud of a pocket")
        << shapes::together(hollow({2, 2, 4}, {8, 8, 10.5F}), box({2.1F, 2.1F, 4.1F}, {7.9F, 7.9F, 10.3F}))
        << 1000.0 - 216 + 5.8 * 5.8 * 5.9;       // above the block, insert and cutter cancel
    const double area = 2 * std::numbers::sqrt2; // area of an octagon of radius 1
    QTest::addRow("cavity with a fine vent") << withVent() << 1000.0 - area * (8 * 16 + 0.999 * 0.09) - 0.001 * 15;
    QTest::addRow("drain through a thin wall")
        << shapes::together(hollow(Vec3f::Constant(0.05F), Vec3f::Constant(9.95F)),
                            shapes::reversed(box({4.7F, 4.7F, -0.1F}, {5.3F, 5.3F, 10.1F})))
        << 1000.0 - 9.9 * 9.9 * 9.9 - 2 * 0.05 * 0.36;
    const std::vector<Vec3f> base{{-3, -3, 8}, {3, -3, 8}, {3, 3, 8}, {-3, 3, 8}},
        tip{{-0.01F, -0.01F, 10.5F}, {0.01F, -0.01F, 10.5F}, {0.01F, 0.01F, 10.5F}, {-0.01F, 0.01F, 10.5F}};
    QTest::addRow("vent that narrows") << shapes::moved(shapes::together(shapes::moved(hollow(Vec3f::Constant(0.05F),
                                                                                              Vec3f::Constant(9.95F)),
                                                                                       {-5, -5, 0}),
                                                                         shapes::reversed(tube({base, tip}))),
                                                        {5, 5, 0})
                                       << 1000.0 - 9.9 * 9.9 * 9.9 - 0.08144;
    // The bore has 0.04 % of the cutter's area.
    QTest::addRow("drain with a fine bore")
        << shapes::together(
               hollow(Vec3f::Constant(0.05F), Vec3f::Constant(9.95F)),
               shapes::reversed(tube({octagon(4, 1), octagon(4, 9), octagon(0.02, 9.001), octagon(0.02, 10.5)})))
        << 1000.0 - 9.9 * 9.9 * 9.9;
    const auto ring = [](float z) {
        return std::vector<Vec3f>{{7, 3, z}, {7, 5, z}, {7, 7, z}, {5, 7, z},
                                  {3, 7, z}, {3, 5, z}, {3, 3, z}, {5, 3, z}};
    };
    QTest::addRow("cavity that is there twice, of other triangles")
        << shapes::together(shell, shapes::reversed(tube({ring(3), ring(5), ring(7)}))) << 936.0;
    // Makes a box whose sides are divided at the middle.
    const auto halved = [](float from, float to) {
        std::vector<std::vector<Vec3f>> rings;
        for (const float z : {from, 5.0F, to})
            rings.push_back({{to, 5, z},
                             {to, to, z},
                             {5, to, z},
                             {from, to, z},
                             {from, 5, z},
                             {from, from, z},
                             {5, from, z},
                             {to, from, z}});
        return tube(rings);
    };
    const TriangleMesh block = halved(0, 10), core = halved(3, 7);
    QTest::addRow("cavity that is there twice, of other triangles in places")
        << shapes::together(shapes::reversed(shapes::together(core, cutOtherwise(core))),
                            box(Vec3f::Zero(), Vec3f::Constant(10)))
        << 936.0;
    QTest::addRow("body that is there twice, of other triangles") << shapes::together(shell, block) << 936.0;
    QTest::addRow("body that is there twice, inside out as a whole")
        << shapes::reversed(shapes::together(shell, block)) << 936.0;
    QTest::addRow("insert that fills a hollow, of other triangles") << shapes::together(shell, core) << 1000.0;
    const auto square = [](float z, std::size_t first) {
        std::vector<Vec3f> corners{{10, 0, z}, {10, 10, z}, {0, 10, z}, {0, 0, z}};
        std::ranges::rotate(corners, corners.begin() + static_cast<std::ptrdiff_t>(first));
        return corners;
    };
    QTest::addRow("boxes that touch, their wall cut by other diagonals")
        << shapes::together(tube({square(0, 0), square(5, 0)}), tube({square(5, 1), square(10, 1)})) << 1000.0;
    QTest::addRow("cutter with a handle outside") << withSlotCutter() << 7200.0 - 0.2 * 16 * 16;
    QTest::addRow("beam that crosses, inside out")
        << shapes::together(box(Vec3f::Zero(), Vec3f::Constant(10)), shapes::reversed(box({3, 3, -5}, {7, 7, 15})))
        << 1160.0;
}

void TestHollowSolids::volume_isKept()
{
    QFETCH(const TriangleMesh, mesh);
    QFETCH(const double, volume);
    StrokeFuzzer random(5);
    const int turns = byEffort(4, 12);
    for (int turn = 0; turn < turns; ++turn) {
        const RepairResult result = repairMesh(turn == 0 ? mesh : turned(mesh, random));
        QVERIFY2(result.mesh, qPrintable(QStringLiteral("turn %1 is refused").arg(turn)));
        QVERIFY2(std::abs(result.report.after.volume / volume - 1) < 1e-3,
                 qPrintable(QStringLiteral("turn %1: %2").arg(turn).arg(result.report.after.volume)));
    }
}

/// A grid of cubes with many common edges and corners. After a rotation, equal corners are rounded differently.
void TestHollowSolids::cubesThatTouch_areTakenApart()
{
    const int side = byEffort(9, 12);
    const unsigned count = byEffort(1, 3, 10);
    for (unsigned seed = 1; seed <= count; ++seed) {
        StrokeFuzzer random(seed);
        TriangleMesh cubes;
        double volume = 0;
        for (int i = 0; i < side * side * side; ++i) {
            if (random.below(2) == 0)
                continue;
            const Vec3f min(static_cast<float>(i % side), static_cast<float>(i / side % side),
                            static_cast<float>(i / side / side));
            cubes = shapes::together(cubes, box(min, min + Vec3f::Ones()));
            volume += 1;
        }
        const RepairResult result = repairMesh(turned(cubes, random));
        QVERIFY2(result.mesh, qPrintable(QString::number(seed)));
        QVERIFY(std::abs(result.report.after.volume / volume - 1) < 5e-3);
    }
}

/// The ends of walls without rims are closed by rims, not by a lid for each wall: bores stay open, in any orientation.
void TestHollowSolids::missingRims_areRings()
{
    constexpr double height = 40, outer = 10, inner = 8, bore = 3;
    StrokeFuzzer random(7);
    const int turns = byEffort(2, 12);
    for (const double deeper : {0.0, 0.2, 1.0}) {
        const TriangleMesh pipe =
            shapes::together(sides(64, outer, Vec3::Zero(), height),
                             shapes::reversed(sides(64, inner, {0, 0, deeper}, height - 2 * deeper)));
        for (int turn = 0; turn < turns; ++turn) {
            const RepairResult result = repairMesh(turn == 0 ? pipe : turned(pipe, random));
            QVERIFY2(result.mesh && result.report.isFaithful(), qPrintable(QString::number(deeper)));
            QCOMPARE(checkMesh(*result.mesh).genus, std::optional<std::int64_t>(1));
        }
    }
    TriangleMesh block = sides(4, 20, Vec3::Zero(), height);
    for (const Vec3& foot : {Vec3(8, 0, 0), Vec3(-5, 5, 0), Vec3(-2, -8, 0)})
        block = shapes::together(block, shapes::reversed(sides(32, bore, foot, height)));
    const double volume = height * (areaOfPrism(4, 20) - 3 * areaOfPrism(32, bore));
    for (int turn = 0; turn < turns; ++turn) {
        const RepairResult result = repairMesh(turn == 0 ? block : turned(block, random));
        QVERIFY(result.mesh && result.report.isFaithful());
        QCOMPARE(checkMesh(*result.mesh).genus, std::optional<std::int64_t>(3));
        QVERIFY(std::abs(result.report.after.volume / volume - 1) < 1e-3);
    }
}

/// A wall without thickness is no rim for itself, however short it is, straight or bevelled.
void TestHollowSolids::shortTubes_getLids()
{
    StrokeFuzzer random(8);
    for (const double height : {1.0, 5.0, 30.0}) {
        const RepairResult result = repairMesh(turned(sides(48, 10, Vec3::Zero(), height), random));
        QVERIFY2(result.mesh, qPrintable(QString::number(height)));
        QVERIFY(std::abs(result.report.after.volume / (height * areaOfPrism(48, 10)) - 1) < 1e-3);
    }
    for (const double bevel : {0.2, 0.5, 2.0}) {
        TriangleMesh coin = sides(48, 10, Vec3::Zero(), 1), upper = sides(48, 10, {0, 0, 1}, 1);
        const auto widen = [&](Vec3f& p) {
            if (p.z() == 1)
                p.head<2>() *= static_cast<float>(1 + bevel / 10);
        };
        std::ranges::for_each(coin.points, widen);
        std::ranges::for_each(upper.points, widen);
        const RepairResult result = repairMesh(turned(shapes::together(coin, upper), random));
        const double factor = 1 + bevel / 10, volume = 2.0 / 3 * areaOfPrism(48, 10) * (1 + factor + factor * factor);
        QVERIFY2(result.mesh, qPrintable(QString::number(bevel)));
        QVERIFY2(std::abs(result.report.after.volume / volume - 1) < 1e-3, qPrintable(QString::number(bevel)));
    }
}

/// The least area would cut off the edge that is missing, and lie on the surface at its ends. So it is with a scan,
/// whose points are off by `noise`.
void TestHollowSolids::openingOverAnEdge_isFilledToTheEdge()
{
    StrokeFuzzer random(9);
    for (const Vec3f& size : {Vec3f(10, 10, 10), Vec3f(10, 20, 35)})
        for (const int cells : {1, 2, 3, 8})
            for (const double noise : {0.0, 0.01}) {
                TriangleMesh open = boxWithoutTwoSides(size, cells);
                std::map<std::tuple<float, float, float>, Vec3f> moved;
                for (Vec3f& p : open.points)
                    p = moved.try_emplace({p.x(), p.y(), p.z()}, p + (noise * random.direction()).cast<float>())
                            .first->second;
                for (const TriangleMesh& mesh : {open, turned(open, random)}) {
                    const RepairResult result = repairMesh(mesh);
                    const QString row = QStringLiteral("%1 %2 %3").arg(size.z()).arg(cells).arg(noise);
                    QVERIFY2(result.mesh, qPrintable(row));
                    QVERIFY2(std::abs(result.report.after.volume / double(size.prod()) - 1) < 1e-3 + noise,
                             qPrintable(row));
                    QCOMPARE(result.report.after.parts, std::size_t(1));
                }
            }
}

/// A notch in a body with round or sloping sides is closed by the least area, which keeps more of the body.
void TestHollowSolids::openingInARoundSide_keepsTheBody()
{
    constexpr Slot count = 90;
    TriangleMesh open = sides(count, 10, Vec3::Zero(), 20);
    TriangleMesh ends; // fans of a cylinder's ends
    for (const bool isUpper : {false, true}) {
        const auto middle = static_cast<Slot>(ends.points.size());
        ends.points.push_back(Vec3f(0, 0, isUpper ? 20.0F : 0.0F));
        for (Slot i = 0; i < count; ++i)
            ends.points.push_back(open.points[2 * i + (isUpper ? 1 : 0)]);
        for (Slot i = 0; i < count; ++i) {
            const Slot a = middle + 1 + i, b = middle + 1 + (i + 1) % count;
            ends.triangles.push_back(isUpper ? Triangle{middle, a, b} : Triangle{middle, b, a});
        }
    }
    open = shapes::together(open, ends);
    const auto isInQuarter = [&](const Triangle& t) {
        return std::ranges::all_of(t,
                                   [&](Slot v) { return open.points[v].x() > -1e-3F && open.points[v].y() > -1e-3F; });
    };
    std::erase_if(open.triangles, isInQuarter);
    const RepairResult result = repairMesh(open);
    QVERIFY(result.mesh);
    QVERIFY(result.report.after.volume > 0.85 * 20 * areaOfPrism(count, 10));
}

FETTLE_TEST(TestHollowSolids)
#include "tst_hollow_solids.moc"
