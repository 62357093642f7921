#include "core/analysis/winding_number.h"
#include "core/geometry/triangle_distance.h"
#include "core/repair/contact_separation.h"
#include "core/repair/knot_covering.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

using namespace core;
using repair::TriangleSoup;

class TestContacts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void edgesOfOneUnit_areNotHalved();
    void knots_lieInTheirCovers();
    void wideKnots_stay();
};

namespace
{
TriangleSoup randomTriangles(StrokeFuzzer& random, int count, double size, double room)
{
    TriangleSoup surface;
    for (int f = 0; f < count; ++f) {
        const Vec3 middle = random.uniform(0, room) * random.direction();
        for (int i = 0; i < 3; ++i)
            surface.points.push_back((middle + size * random.direction()).array().round().matrix().cast<int>());
        const auto last = static_cast<Slot>(surface.points.size() - 1);
        surface.triangles.push_back({last - 2, last - 1, last});
    }
    return surface;
}

std::array<Vec3, 3> cornersOf(const TriangleSoup& surface, Slot face)
{
    const Triangle& t = surface.triangles[face];
    const auto at = [&](Slot v) { return Vec3(surface.points[v].cast<double>()); };
    return {at(t[0]), at(t[1]), at(t[2])};
}
} // namespace

/// The model has two tetrahedra on both sides of an edge of one lattice unit. The edge has no lattice point in its
/// middle, so it cannot be halved.
void TestContacts::edgesOfOneUnit_areNotHalved()
{
    TriangleSoup surface;
    for (const auto& [x, y, z] :
         {std::array{0, 0, 0}, {1, 0, 0}, {0, 500, 300}, {0, 500, -300}, {0, -500, 300}, {0, -500, -300}})
        surface.points.emplace_back(x, y, z);
    for (const auto& [c, d] : {std::pair<Slot, Slot>(2, 3), {5, 4}})
        for (const Triangle& t : {Triangle{0, 1, d}, Triangle{1, 0, c}, Triangle{0, d, c}, Triangle{1, c, d}})
            surface.triangles.push_back(t);
    const repair::SeparationResult separated = repair::separateContacts(surface);
    QCOMPARE(separated.edges, std::size_t(0));
    for (const Slot end : {0, 1})
        QVERIFY(std::ranges::find(separated.stuck, end) != separated.stuck.end());
    for (const auto& [a, b, c] : surface.triangles)
        QVERIFY(!LatticePredicates::collinear(surface.points[a], surface.points[b], surface.points[c]));
}

/// Checks that the places where faces meet are inside the cover solids.
void TestContacts::knots_lieInTheirCovers()
{
    std::size_t all = 0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
        StrokeFuzzer random(seed);
        TriangleSoup surface = randomTriangles(random, 40, 300, 2500);
        const auto met = selfIntersections<LatticePredicates>(surface.points, surface.triangles, 10'000);
        const std::size_t faces = surface.triangles.size();
        const repair::CoveredKnots covered = repair::coverKnots(surface, met.pairs, 1e6);
        QCOMPARE(surface.triangles.size(), faces + 8 * covered.count);
        QVERIFY(covered.count <= met.pairs.size() && (covered.count > 0) == !met.pairs.empty());
        const std::vector<Vec3> places = surface.places();
        const WindingNumber covers(places, std::span(surface.triangles).subspan(faces));
        for (const FacePair& pair : met.pairs) {
            const NearestPair common =
                nearestOfTriangles(cornersOf(surface, pair.first), cornersOf(surface, pair.second));
            QVERIFY(common.squaredDistance < 1);
            QVERIFY2(covers.at(common.a) > 0.9, qPrintable(QString::number(seed)));
        }
        all += covered.count;
    }
    QVERIFY(all > 20);
}

void TestContacts::wideKnots_stay()
{
    StrokeFuzzer random(1);
    TriangleSoup surface = randomTriangles(random, 30, 5000, 1000);
    const auto met = selfIntersections<LatticePredicates>(surface.points, surface.triangles, 10'000);
    QVERIFY(!met.pairs.empty());
    QCOMPARE(repair::coverKnots(surface, met.pairs, 500).count, std::size_t(0));
    QCOMPARE(surface.triangles.size(), std::size_t(30));
}

FETTLE_TEST(TestContacts)
#include "tst_contacts.moc"
