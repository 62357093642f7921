#include "core/repair/orientation.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <utility>
#include <vector>

using namespace core;
using repair::TriangleSoup;

class TestOrientation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void doubledColumn_facesOutwards();
};

namespace
{
/// Adds a square about the z axis with half diagonal `radius`. Returns the first of its four points, which are in
/// counter-clockwise order as seen from above.
Slot addSquare(TriangleSoup& surface, int radius, int z)
{
    for (const auto& [x, y] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}})
        surface.points.emplace_back(radius * x, radius * y, z);
    return static_cast<Slot>(surface.points.size() - 4);
}

/// Adds a square's two triangles.
void addEnd(TriangleSoup& surface, Slot square, bool isUpper)
{
    for (const Slot i : {1, 2})
        surface.triangles.push_back({square, square + (isUpper ? i : i + 1), square + (isUpper ? i + 1 : i)});
}

void addSides(TriangleSoup& surface, Slot lower, Slot upper)
{
    for (Slot i = 0; i < 4; ++i) {
        const Slot next = (i + 1) % 4;
        surface.triangles.push_back({lower + i, lower + next, upper + next});
        surface.triangles.push_back({lower + i, upper + next, upper + i});
    }
}
} // namespace

/// The sides of a column are there twice, with different triangles, and its ends once. The lower end is in a base,
/// where it is not visible from outside.
void TestOrientation::doubledColumn_facesOutwards()
{
    TriangleSoup surface;
    const Slot ground = addSquare(surface, 3000, 0), top = addSquare(surface, 3000, 1000);
    addEnd(surface, ground, false);
    addSides(surface, ground, top);
    addEnd(surface, top, true);
    const std::size_t base = surface.triangles.size();
    const Slot foot = addSquare(surface, 800, 950), middle = addSquare(surface, 800, 3000),
               head = addSquare(surface, 800, 6000);
    addSides(surface, foot, head);
    addSides(surface, foot, middle);
    addSides(surface, middle, head);
    const std::size_t sides = surface.triangles.size() - base;
    addEnd(surface, head, true);
    addEnd(surface, foot, false);

    repair::orient(surface);
    const std::vector<Vec3> points = surface.places();
    std::size_t outward = 0;
    for (const Triangle& t : surface.triangles) {
        const Vec3 normal = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
        const Vec3 away = points[t[0]] + points[t[1]] + points[t[2]];
        if (std::ranges::min(t) >= foot && normal.z() == 0)
            outward += normal.dot(away) > 0;
    }
    QCOMPARE(outward, sides);
}

FETTLE_TEST(TestOrientation)
#include "tst_orientation.moc"
