#include "core/analysis/part_overlap.h"

#include "core/analysis/mesh_check.h"
#include "core/parts/part_split.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

using namespace core;

namespace
{
/// Returns a mesh in which each solid is a part.
TriangleMesh parts(const std::vector<TriangleMesh>& solids)
{
    std::vector<PartPiece> pieces;
    for (const TriangleMesh& solid : solids)
        pieces.push_back({static_cast<PartId>(pieces.size() + 3), solid, {}, {}});
    return joined(pieces);
}

TriangleMesh cubeAt(const Vec3f& at)
{
    return shapes::moved(shapes::cube(2), at);
}
} // namespace

class TestPartOverlap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void apart_isNoOverlap();
    void sharedSpaceOrSurface_isOverlap();
    void order_doesNotMatter();
};

void TestPartOverlap::apart_isNoOverlap()
{
    QVERIFY(!doPartsOverlap(cubeAt({0, 0, 0})));
    QVERIFY(!doPartsOverlap(parts({cubeAt({0, 0, 0})})));
    QVERIFY(!doPartsOverlap(parts({cubeAt({0, 0, 0}), cubeAt({2.5f, 0, 0}), cubeAt({0, 0, -9})})));
    // the boxes meet, but not the balls
    QVERIFY(!doPartsOverlap(parts({icosphere(2, 1), shapes::moved(icosphere(2, 1), {1.5f, 1.5f, 1.5f})})));
    // inside a void
    QVERIFY(!doPartsOverlap(parts({shapes::nestedSpheres(true), shapes::scaled(icosphere(2, 1), 0.1f)})));
}

void TestPartOverlap::sharedSpaceOrSurface_isOverlap()
{
    const TriangleMesh cube = cubeAt({0, 0, 0});
    QVERIFY(doPartsOverlap(parts({cube, cubeAt({1, 1, 1})})));
    QVERIFY(doPartsOverlap(parts({cube, cube})));
    QVERIFY(doPartsOverlap(parts({cube, cubeAt({2, 0, 0})})));                      // face on face
    QVERIFY(doPartsOverlap(parts({cube, cubeAt({2, 2, 0})})));                      // edge on edge
    QVERIFY(doPartsOverlap(parts({cube, cubeAt({2, 2, 2})})));                      // corner on corner
    QVERIFY(doPartsOverlap(parts({icosphere(2, 9), shapes::cube(2)})));             // inside the material
    QVERIFY(doPartsOverlap(parts({cube, cubeAt({50, 0, 0}), cubeAt({51, 0, 0})}))); // only the last two
}

void TestPartOverlap::order_doesNotMatter()
{
    std::vector<TriangleMesh> solids = {cubeAt({0, 0, 0}), cubeAt({9, 0, 0}), cubeAt({0, 7, 0}), cubeAt({0, 8, 0}),
                                        cubeAt({0, 0, 20})};
    std::vector<std::size_t> order = {0, 1, 2, 3, 4};
    do {
        std::vector<TriangleMesh> sorted;
        for (const std::size_t i : order)
            sorted.push_back(solids[i]);
        QVERIFY(doPartsOverlap(parts(sorted)));
        std::erase_if(sorted, [&](const TriangleMesh& solid) { return solid.points == solids[3].points; });
        QVERIFY(!doPartsOverlap(parts(sorted)));
    } while (std::ranges::next_permutation(order).found);
}

FETTLE_TEST(TestPartOverlap)
#include "tst_part_overlap.moc"
