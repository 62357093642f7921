#include "tests/support/cgal_judge.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "core/decimation/decimate.h"
#include "core/mesh/mesh_builder.h"
#include "core/primitives/starter_models.h"

#include <QTest>

#include <array>
#include <cmath>
#include <map>

using core::Rgb;
using core::TriangleMesh;
using core::Vec3;
using core::Vec3f;

namespace
{
TriangleMesh wavyBall()
{
    TriangleMesh mesh = core::icosphere(5, 50);
    for (Vec3f& p : mesh.points)
        p *= 1 + 0.08F * std::sin(0.2F * p.x()) * std::sin(0.25F * p.y());
    return mesh;
}

/// Returns a two-coloured ball: blue where x y z > 0, elsewhere red.
TriangleMesh twoColored()
{
    TriangleMesh mesh = core::icosphere(5, 50);
    for (const Vec3f& p : mesh.points)
        mesh.colors.push_back(p.x() * p.y() * p.z() > 0 ? Rgb{20, 40, 220} : Rgb{220, 40, 20});
    return mesh;
}

core::Mesh built(const TriangleMesh& mesh)
{
    return std::move(*core::buildMesh(mesh).mesh);
}

/// Returns V - E + F. Precondition: the surface is closed.
std::int64_t eulerNumber(const TriangleMesh& mesh)
{
    return static_cast<std::int64_t>(mesh.points.size()) - static_cast<std::int64_t>(mesh.triangles.size()) / 2;
}

/// Returns the surface of those unit cubes of a grid of size x size x size for which `isThere` returns true.
template <class IsThere> TriangleMesh voxels(int size, IsThere isThere)
{
    TriangleMesh mesh;
    std::map<std::array<int, 3>, core::Slot> corners;
    const auto corner = [&](const std::array<int, 3>& p) {
        const auto [found, isNew] = corners.emplace(p, static_cast<core::Slot>(mesh.points.size()));
        if (isNew)
            mesh.points.emplace_back(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]));
        return found->second;
    };
    const auto isSolid = [&](const std::array<int, 3>& p) {
        return std::ranges::all_of(p, [&](int x) { return x >= 0 && x < size; }) && isThere(p[0], p[1], p[2]);
    };
    for (int i = 0; i < size * size * size; ++i) {
        const std::array<int, 3> cell = {i % size, i / size % size, i / size / size};
        if (!isSolid(cell))
            continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const int side : {0, 1}) {
                std::array<int, 3> beside = cell, p = cell;
                beside[axis] += 2 * side - 1;
                if (isSolid(beside))
                    continue;
                const std::size_t u = (axis + (side == 1 ? 1 : 2)) % 3, v = 3 - axis - u;
                p[axis] += side;
                const core::Slot a = corner(p);
                const core::Slot b = corner((++p[u], p));
                const core::Slot c = corner((++p[v], p));
                const core::Slot d = corner((--p[u], p));
                mesh.triangles.push_back({a, b, c});
                mesh.triangles.push_back({a, c, d});
            }
        }
    }
    return mesh;
}

double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    // Source: Ericson, Real-Time Collision Detection, section 5.1.5.
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    Vec3 nearest = a + (vb * ab + vc * ac) / (va + vb + vc);
    if (d1 <= 0 && d2 <= 0)
        nearest = a;
    else if (d3 >= 0 && d4 <= d3)
        nearest = b;
    else if (d6 >= 0 && d5 <= d6)
        nearest = c;
    else if (vc <= 0 && d1 >= 0 && d3 <= 0)
        nearest = a + d1 / (d1 - d3) * ab;
    else if (vb <= 0 && d2 >= 0 && d6 <= 0)
        nearest = a + d2 / (d2 - d6) * ac;
    else if (va <= 0 && d4 >= d3 && d5 >= d6)
        nearest = b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b);
    return (p - nearest).squaredNorm();
}

/// Returns the largest distance of a vertex of `from` from the other surface. Only every `step`-th vertex is tested.
double farthest(const TriangleMesh& from, const TriangleMesh& surface, std::size_t step)
{
    double most = 0;
    for (std::size_t i = 0; i < from.points.size(); i += step) {
        double least = 1e300;
        for (const core::Triangle& t : surface.triangles)
            least = std::min(least,
                             squaredDistance(from.points[i].cast<double>(), surface.points[t[0]].cast<double>(),
                                             surface.points[t[1]].cast<double>(), surface.points[t[2]].cast<double>()));
        most = std::max(most, least);
    }
    return std::sqrt(most);
}
} // namespace

class TestDecimate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void surface_staysSound_data();
    void surface_staysSound();
    void flatFaces_needNoTriangles();
    void colors_stayWhereTheyAre();
    void tooSmallABudget_keepsTopology();
    void tooSmallABudget_isToldWithItsReason();
    void handlesAndShells_needFewMore_data();
    void handlesAndShells_needFewMore();
    void enough_changesNothing();
    void sameInput_sameBits();
    void stopped_givesNothing();
    void closeSheets_doNotMeet();
};

void TestDecimate::surface_staysSound_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<int>("triangles");
    QTest::addColumn<double>("within"); ///< largest distance between the surfaces, mm
    QTest::newRow("ball, a tenth") << core::icosphere(5, 50) << 2048 << 0.3;
    QTest::newRow("ball, a hundredth") << core::icosphere(5, 50) << 204 << 2.0;
    QTest::newRow("waves") << wavyBall() << 2000 << 0.6;
    QTest::newRow("two colours") << twoColored() << 2000 << 2.0;
    QTest::newRow("torus") << shapes::scaled(shapes::torus({3, 1, 120, 60}), 10) << 1000 << 0.6;
    QTest::newRow("bowl") << shapes::scaled(clay::bowl(), 50) << 500 << 1.5;
    QTest::newRow("shell with a cavity") << shapes::scaled(shapes::nestedSpheres(true), 20) << 60 << 8.0;
    QTest::newRow("head") << core::starterModel(core::Starter::Head) << 1000 << 1.5;
    QTest::newRow("noise") << shapes::noisy(core::icosphere(5, 50), 0.1F, 3) << 3000 << 0.6;
}

void TestDecimate::surface_staysSound()
{
    QFETCH(TriangleMesh, mesh);
    QFETCH(int, triangles);
    QFETCH(double, within);
    const core::BuildResult input = core::buildMesh(mesh);
    QVERIFY(input.mesh);
    const TriangleMesh before = core::extractMesh(*input.mesh);
    const core::Lattice lattice = input.mesh->lattice();
    const TriangleMesh few = core::decimate(*input.mesh, static_cast<std::size_t>(triangles)).mesh;
    QVERIFY(few.triangles.size() <= static_cast<std::size_t>(triangles) &&
            few.triangles.size() + 2 > static_cast<std::size_t>(triangles) - 1);
    const auto verdict = judgedByCgal(few);
    QVERIFY(verdict && verdict->allWell());
    QCOMPARE(eulerNumber(few), eulerNumber(before));
    QVERIFY(std::ranges::all_of(few.points, [&](const Vec3f& p) { return lattice.isOnLattice(p); }));
    const double there = farthest(few, before, 1 + few.points.size() / 500),
                 back = farthest(before, few, 1 + before.points.size() / 1000);
    QVERIFY2(std::max(there, back) < within, qPrintable(QStringLiteral("%1 mm and back %2 mm").arg(there).arg(back)));
}

/// Flat faces need no inner vertices: a slab of thousands of triangles becomes one of twelve, with its edges unmoved.
void TestDecimate::flatFaces_needNoTriangles()
{
    const TriangleMesh slab = clay::slab(40, 10, 24);
    const TriangleMesh few = core::decimate(built(slab), 12).mesh;
    QCOMPARE(few.triangles.size(), std::size_t(12));
    QVERIFY(farthest(slab, few, 1) < 1e-3 && farthest(few, slab, 1) < 1e-3);
}

/// Away from colour borders, each remaining vertex must have almost the original colour of its position.
void TestDecimate::colors_stayWhereTheyAre()
{
    const TriangleMesh mesh = twoColored();
    const TriangleMesh few = core::decimate(built(mesh), 2000).mesh;
    QCOMPARE(few.colors.size(), few.points.size());
    std::size_t wrong = 0, looked = 0;
    for (std::size_t i = 0; i < few.points.size(); ++i) {
        const Vec3f p = few.points[i];
        if (p.cwiseAbs().minCoeff() < 4) // at a border between colours
            continue;
        ++looked;
        const Rgb expected = p.x() * p.y() * p.z() > 0 ? Rgb{20, 40, 220} : Rgb{220, 40, 20};
        const Rgb c = few.colors[i];
        wrong += std::abs(c.r - expected.r) > 12 || std::abs(c.g - expected.g) > 12 || std::abs(c.b - expected.b) > 12
                     ? 1U
                     : 0U;
    }
    QVERIFY(looked > few.points.size() / 10);
    QCOMPARE(wrong, std::size_t(0));
    // Triangles are denser where colours meet.
    const auto near = [](const Vec3f& p) { return p.cwiseAbs().minCoeff() < 4; };
    const auto share = [&](const TriangleMesh& m) {
        return static_cast<double>(std::ranges::count_if(m.points, near)) / static_cast<double>(m.points.size());
    };
    QVERIFY(share(few) > 1.5 * share(mesh));
}

void TestDecimate::tooSmallABudget_keepsTopology()
{
    const TriangleMesh torus = core::decimate(built(shapes::torus({3, 1, 48, 24})), 4).mesh;
    QCOMPARE(eulerNumber(torus), 0);
    const TriangleMesh shells = core::decimate(built(shapes::scaled(shapes::nestedSpheres(true), 20)), 4).mesh;
    QCOMPARE(eulerNumber(shells), 4);
    for (const TriangleMesh* mesh : {&torus, &shells}) {
        const auto verdict = judgedByCgal(*mesh);
        QVERIFY(verdict && verdict->allWell());
        QVERIFY2(mesh->triangles.size() <= 60, qPrintable(QString::number(mesh->triangles.size())));
    }
}

/// Twenty rings must keep their holes. Each needs at least 14 triangles, so 200 in total cannot be reached.
void TestDecimate::tooSmallABudget_isToldWithItsReason()
{
    constexpr std::size_t rings = 20, asked = 200;
    TriangleMesh row;
    for (std::size_t i = 0; i < rings; ++i) {
        const float at = 30 * static_cast<float>(i);
        row = shapes::together(row, shapes::moved(shapes::torus({10, 2, 32, 12}), {at, 0, 0}));
    }
    const core::Decimated few = core::decimate(built(row), asked);
    QVERIFY2(few.mesh.triangles.size() <= rings * 21, qPrintable(QString::number(few.mesh.triangles.size())));
    QCOMPARE(core::fewestTriangles(few.mesh), rings * 14);
    QCOMPARE(core::fewestTriangles(row), rings * 14);
    QVERIFY(few.mesh.triangles.size() >= rings * 14);
    QCOMPARE(core::fewestTriangles(shapes::together(shapes::tetrahedron(), row)), rings * 14 + 4);
    QCOMPARE(eulerNumber(few.mesh), 0);
    const auto verdict = judgedByCgal(few.mesh);
    QVERIFY(verdict && verdict->allWell());
    const core::Decimated enough = core::decimate(built(row), few.mesh.triangles.size());
    QVERIFY(enough.mesh.triangles.size() <= few.mesh.triangles.size()); // a budget of that many triangles can be met
}

/// `share`: budget as a multiple of the number that topology requires
void TestDecimate::handlesAndShells_needFewMore_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<double>("share");
    QTest::newRow("ring") << shapes::scaled(shapes::torus({3, 1, 60, 30}), 10) << 1.15;
    QTest::newRow("thin ring") << shapes::torus({100, 0.5F, 120, 6}) << 1.15;
    TriangleMesh rings, chain;
    for (int i = 0; i < 4; ++i) {
        TriangleMesh ring = shapes::torus({10, 2, 32, 12});
        rings = shapes::together(rings, shapes::moved(ring, {30 * static_cast<float>(i), 0, 0}));
        if (i % 2 == 1)
            for (Vec3f& p : ring.points)
                p = {p.x(), -p.z(), p.y()};
        chain = shapes::together(chain, shapes::moved(ring, {15 * static_cast<float>(i), 0, 0}));
    }
    QTest::newRow("rings") << rings << 1.15;
    QTest::newRow("chain") << chain << 1.5;
    QTest::newRow("sponge") << voxels(9, [](int x, int y, int z) {
        return (x / 3 == 1) + (y / 3 == 1) + (z / 3 == 1) < 2;
    }) << 1.15;
    QTest::newRow("drilled box") << voxels(9, [](int x, int y, int z) {
        return !(x == 2 && z == 2) && !(x == 6 && z == 6) && !(x == 4 && y == 4) && !(y == 2 && z == 6);
    }) << 1.15;
    TriangleMesh onion;
    for (int i = 0; i < 4; ++i) {
        const TriangleMesh shell = core::icosphere(3, 20 - 0.05 * i);
        onion = shapes::together(onion, i % 2 == 0 ? shell : shapes::reversed(shell));
    }
    QTest::newRow("onion") << onion << 1.15;
}

void TestDecimate::handlesAndShells_needFewMore()
{
    QFETCH(TriangleMesh, mesh);
    QFETCH(double, share);
    const auto needed = static_cast<double>(core::fewestTriangles(mesh));
    const auto asked = static_cast<std::size_t>(share * needed);
    const core::Mesh before = built(mesh);
    const TriangleMesh few = core::decimate(before, asked).mesh;
    QVERIFY2(few.triangles.size() <= asked,
             qPrintable(QStringLiteral("%1 for %2").arg(few.triangles.size()).arg(needed)));
    QCOMPARE(eulerNumber(few), eulerNumber(core::extractMesh(before)));
    QCOMPARE(core::fewestTriangles(few), core::fewestTriangles(mesh));
    const auto verdict = judgedByCgal(few);
    QVERIFY(verdict && verdict->allWell());
    const TriangleMesh again = core::decimate(before, asked).mesh;
    QVERIFY(again.points == few.points && again.triangles == few.triangles);
}

void TestDecimate::enough_changesNothing()
{
    const core::BuildResult input = core::buildMesh(twoColored());
    const TriangleMesh before = core::extractMesh(*input.mesh),
                       after = core::decimate(*input.mesh, before.triangles.size()).mesh;
    QVERIFY(after.points == before.points && after.triangles == before.triangles && after.colors == before.colors);
}

void TestDecimate::sameInput_sameBits()
{
    const TriangleMesh one = core::decimate(built(twoColored()), 1500).mesh,
                       two = core::decimate(built(twoColored()), 1500).mesh;
    QVERIFY(one.points == two.points && one.triangles == two.triangles && one.colors == two.colors);
}

void TestDecimate::stopped_givesNothing()
{
    std::stop_source stop;
    double last = 0;
    core::JobControl control{stop.get_token(), [&](double share) {
                                 QVERIFY(share >= last && share <= 1);
                                 last = share;
                                 stop.request_stop();
                             }};
    QVERIFY(core::decimate(built(wavyBall()), 500, control).mesh.triangles.empty());
    QVERIFY(last > 0 && last < 1);
}

/// Triangles of one layer must not pass through a near layer. Such collapses are undone, and others are made.
void TestDecimate::closeSheets_doNotMeet()
{
    for (const TriangleMesh& mesh : {clay::spiral(), clay::cutRing(0.02), clay::twoFingers(0.01)}) {
        const core::Decimated result = core::decimate(built(mesh), 300);
        const auto verdict = judgedByCgal(result.mesh);
        QVERIFY(verdict && verdict->allWell());
        QCOMPARE(eulerNumber(result.mesh), eulerNumber(mesh));
        QVERIFY(result.mesh.triangles.size() < mesh.triangles.size() / 2);
    }
}

FETTLE_TEST(TestDecimate)
#include "tst_decimate.moc"
