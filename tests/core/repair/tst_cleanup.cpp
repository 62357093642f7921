#include "core/geometry/predicates.h"
#include "core/repair/cleanup.h"
#include "core/repair/edge_faces.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

using namespace core;
using repair::Duplicates;
using repair::TriangleSoup;

namespace
{
/// Returns an octahedron with its vertices on the axes.
TriangleSoup octahedron(int radius)
{
    TriangleSoup surface;
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {1, -1})
            surface.points.push_back(LatticePoint(radius * sign * LatticePoint::Unit(axis)));
    for (const auto& [x, y, z] : {std::array{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}})
        surface.triangles.push_back({Slot(x), Slot(2 + y), Slot(4 + z)});
    for (const auto& [x, y, z] : {std::array{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}})
        surface.triangles.push_back({Slot(x), Slot(4 + z), Slot(2 + y)});
    return surface;
}

/// Splits an edge at a point. Each face at the edge is divided into two.
void split(TriangleSoup& surface, Slot from, Slot to, const LatticePoint& by)
{
    const auto middle = static_cast<Slot>(surface.points.size());
    surface.points.push_back(by);
    std::vector<Triangle> result;
    for (const Triangle& t : surface.triangles) {
        bool isSplit = false;
        for (std::size_t i = 0; i < 3 && !isSplit; ++i) {
            const Slot a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
            isSplit = std::minmax(a, b) == std::minmax(from, to);
            if (isSplit) {
                result.push_back({a, middle, c});
                result.push_back({middle, b, c});
            }
        }
        if (!isSplit)
            result.push_back(t);
    }
    surface.triangles = std::move(result);
}

bool isClosed(const TriangleSoup& surface)
{
    bool isEven = true;
    repair::forEachEdge(surface.triangles, [&](std::span<const repair::EdgeFace> around) {
        isEven = isEven && 2 * std::ranges::count(around, true, &repair::EdgeFace::forward) == std::ssize(around);
    });
    return isEven;
}

std::int64_t sixVolumesOf(const TriangleSoup& surface)
{
    std::int64_t sum = 0;
    for (const auto& [a, b, c] : surface.triangles) {
        const auto at = [&](Slot v) {
            return Eigen::Matrix<std::int64_t, 3, 1>(surface.points[v].cast<std::int64_t>());
        };
        sum += at(a).dot(at(b).cross(at(c)));
    }
    return sum;
}
} // namespace

class TestCleanup : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void flatFaces_go();
};

/// Splits edges at random, in the middle or at an end. A split at an end gives a face with two corners at the same
/// point.
void TestCleanup::flatFaces_go()
{
    for (unsigned seed = 1; seed <= 300; ++seed) {
        StrokeFuzzer random(seed);
        TriangleSoup surface = octahedron(1 << 10);
        QVERIFY(isClosed(surface));
        const std::int64_t volume = sixVolumesOf(surface);
        for (int i = 0; i < 12; ++i) {
            const Triangle t = surface.triangles[random.below(surface.triangles.size())];
            const LatticePoint &a = surface.points[t[0]], &b = surface.points[t[1]];
            const LatticePoint middle = (a + b) / 2;
            const bool isOnEdge = (b - a).cross(middle - a) == LatticePoint::Zero();
            split(surface, t[0], t[1], isOnEdge && random.below(2) == 0 ? middle : a);
        }
        repair::cleanUp(surface, Duplicates::Cancel);
        QVERIFY2(isClosed(surface), qPrintable(QString::number(seed)));
        QCOMPARE(sixVolumesOf(surface), volume);
        for (const auto& [a, b, c] : surface.triangles)
            QVERIFY(!LatticePredicates::collinear(surface.points[a], surface.points[b], surface.points[c]));
    }
}

FETTLE_TEST(TestCleanup)
#include "tst_cleanup.moc"
