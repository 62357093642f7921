#include "core/analysis/winding_number.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include "core/mesh/mesh_builder.h"

#include <QTest>

#include <cmath>
#include <map>
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
    void shellsInEachOther_areExact();
    void raysThroughVerticesAndEdges_areCountedOnce();
    void openSurfaces_matchTheirSolidAngles_data();
    void openSurfaces_matchTheirSolidAngles();
    void pointsBelowBorders_areExact();
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

/// Tests points in and around tori in many random pieces, of which most are summed by dipoles: all pieces together wind
/// around a point 0 times or once.
void TestWindingNumber::dipoles_areAccurate()
{
    const TriangleMesh torus = shapes::torus({.around = 120, .across = 60});
    const WindingNumber solid(torus);
    std::array<std::vector<Triangle>, 2> pieces; // with borders all over
    for (std::size_t f = 0; f < torus.triangles.size(); ++f)
        pieces[f % 3 == 0 ? 0 : 1].push_back(torus.triangles[f]);
    const std::vector<Vec3> places = placesOf(torus);
    const WindingNumber some(places, pieces[0]), others(places, pieces[1]);
    StrokeFuzzer random(7);
    constexpr int count = 10'000;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3 p = random.uniform(0, 5) * random.direction();
        const double error = std::abs(some.at(p) + others.at(p) - solid.at(p));
        QVERIFY2(error < 0.05, qPrintable(QStringLiteral("point %1: %2").arg(i).arg(error)));
        sum += error;
    }
    QVERIFY(sum / count < 0.01);
}

/// Tests random points against three balls in each other: solid, void, solid.
void TestWindingNumber::shellsInEachOther_areExact()
{
    const TriangleMesh solid =
        shapes::together(shapes::together(icosphere(4, 3), shapes::reversed(icosphere(3, 2))), icosphere(4, 1));
    const WindingNumber winding(solid);
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
        QVERIFY2(winding.at(p) == (isInside ? 1 : 0), qPrintable(QStringLiteral("at distance %1").arg(distance)));
    }
    QVERIFY(inside > 5000);
}

/// Tests a grid of points straight below the vertices, edges and diagonals of blocks.
void TestWindingNumber::raysThroughVerticesAndEdges_areCountedOnce()
{
    const TriangleMesh solid = shapes::together(shapes::cube(1), shapes::moved(shapes::cube(1), Vec3f(0, 0, 3)));
    const WindingNumber winding(solid);
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
                    QCOMPARE(winding.at(p), isInside ? 1.0 : 0.0);
            }
        }
    }
    QCOMPARE(inside, 7 * 7 * 3);
}

void TestWindingNumber::openSurfaces_matchTheirSolidAngles_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    const auto without = [](TriangleMesh mesh, std::size_t from, std::size_t count) {
        const auto first = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(from);
        mesh.triangles.erase(first, first + static_cast<std::ptrdiff_t>(count));
        return mesh;
    };
    QTest::newRow("ball with a hole of one face") << without(icosphere(3, 1), 100, 1);
    QTest::newRow("ball without a third") << without(icosphere(3, 1), 0, 400);
    QTest::newRow("cube without a face") << without(shapes::cube(1), 3, 1);
    QTest::newRow("cube without two faces") << without(shapes::cube(1), 2, 2);
    QTest::newRow("ball with a hole, in another")
        << shapes::together(without(icosphere(3, 0.5F), 7, 30), icosphere(3, 1));
    QTest::newRow("open ball that is there twice")
        << shapes::together(without(icosphere(3, 1), 0, 90), without(icosphere(3, 1), 0, 90));
}

/// Compares with the sum of all solid angles: at random points, and in the middles of faces, which do not count there.
void TestWindingNumber::openSurfaces_matchTheirSolidAngles()
{
    QFETCH(const TriangleMesh, mesh);
    const std::vector<Vec3> places = placesOf(mesh);
    const WindingNumber winding(mesh);
    const auto sumAt = [&](const Vec3& p, Slot except) {
        double sum = 0;
        for (Slot f = 0; f < mesh.triangles.size(); ++f) {
            const auto& [a, b, c] = mesh.triangles[f];
            sum += f == except ? 0 : solidAngle(places[a] - p, places[b] - p, places[c] - p);
        }
        return sum / (4 * std::numbers::pi);
    };
    StrokeFuzzer random(3);
    for (int i = 0; i < 300; ++i) {
        const Vec3 p = random.uniform(0, 2) * random.direction();
        QVERIFY(std::abs(winding.at(p) - sumAt(p, noSlot)) < 1e-9);
    }
    const bool isDoubled = std::string_view(QTest::currentDataTag()).ends_with("twice"); // faces lie on each other
    for (Slot f = 0; f < mesh.triangles.size() && !isDoubled; ++f) {
        const auto& [a, b, c] = mesh.triangles[f];
        const Vec3 p = 0.4 * places[a] + 0.35 * places[b] + 0.25 * places[c];
        QVERIFY2(std::abs(winding.at(p, std::span(&f, 1)) - sumAt(p, f)) < 1e-9, qPrintable(QString::number(f)));
    }
}

/// Tests lattice points around a block with two holes in its lid, many of them straight below and above corners, edges
/// and diagonals of the holes.
void TestWindingNumber::pointsBelowBorders_areExact()
{
    constexpr int cells = 4, cell = 14;
    std::map<std::array<int, 3>, Slot> numbers;
    std::vector<Vec3> places;
    std::vector<Triangle> triangles;
    const auto corner = [&](const std::array<int, 3>& at) {
        const auto [found, isNew] = numbers.try_emplace(at, static_cast<Slot>(places.size()));
        if (isNew)
            places.emplace_back(cell * at[0], cell * at[1], cell * at[2]);
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, cells})
            for (int i = 0; i < cells; ++i)
                for (int j = 0; j < cells; ++j) {
                    if (axis == 2 && side == cells && j == 1 && (i == 1 || i == 2))
                        continue; // the holes
                    const auto at = [&](int u, int v) {
                        std::array<int, 3> place{};
                        place[static_cast<std::size_t>(axis)] = side;
                        place[static_cast<std::size_t>((axis + 1) % 3)] = u;
                        place[static_cast<std::size_t>((axis + 2) % 3)] = v;
                        return corner(place);
                    };
                    const Slot a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
                    triangles.push_back(side == 0 ? Triangle{a, c, b} : Triangle{a, b, c});
                    triangles.push_back(side == 0 ? Triangle{a, d, c} : Triangle{a, c, d});
                }
    const WindingNumber winding(places, triangles);
    for (int x = -1; x <= 2 * cells + 1; ++x)
        for (int y = -1; y <= 2 * cells + 1; ++y)
            for (const int z : {-1000, -3, 1, 13, 55, 57, 200}) {
                const Vec3 p(cell / 2 * x, cell / 2 * y, z);
                const auto isSide = [](int w) { return w == 0 || w == 2 * cells; };
                if (z > 0 && z < cell * cells && (isSide(x) || isSide(y)))
                    continue; // on the surface
                double sum = 0;
                for (const auto& [a, b, c] : triangles)
                    sum += solidAngle(places[a] - p, places[b] - p, places[c] - p) / (4 * std::numbers::pi);
                QVERIFY2(
                    std::abs(winding.at(p) - sum) < 1e-9,
                    qPrintable(
                        QStringLiteral("(%1, %2, %3): %4, not %5").arg(x).arg(y).arg(z).arg(winding.at(p)).arg(sum)));
            }
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
