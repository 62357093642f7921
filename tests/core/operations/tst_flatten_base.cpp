// Tests the flat base and placing on the bed: exact results on named solids, CGAL's verdict on random ones.

#include "core/geometry/polygon_triangulation.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/model_command.h"
#include "core/print/print_check.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

using core::FlatPoint;
using core::FlattenBase;
using core::Mesh;
using core::ModelChange;
using core::ModelRefusal;
using core::PlaceOnBed;
using core::Slot;
using core::Triangle;
using core::TriangleMesh;
using core::Vec3f;
using mesh_asserts::sculptable;

class TestFlattenBase : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void polygons_areFilled_data();
    void polygons_areFilled();
    void polygons_thatAreNone();
    void base_isFlat_data();
    void base_isFlat();
    void base_keepsWhatLiesAbove();
    void base_ofTheWrongHeightIsRefused();
    void base_ofRandomModels();
    void stopped_changesNothing();
    void bed_isAtZero_data();
    void bed_isAtZero();
    void bed_twiceIsOnce();
};

namespace
{
using Loop = std::vector<FlatPoint>;

Loop ring(double radius, int corners, const FlatPoint& centre, bool isHole)
{
    Loop loop;
    for (int i = 0; i < corners; ++i) {
        const double angle = (isHole ? -2 : 2) * 3.14159265358979 * i / corners;
        loop.emplace_back(centre.x() + std::lround(radius * std::cos(angle)),
                          centre.y() + std::lround(radius * std::sin(angle)));
    }
    return loop;
}

std::int64_t twiceArea(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c)
{
    const auto x = [](const FlatPoint& p) { return std::int64_t(p.x()); };
    const auto y = [](const FlatPoint& p) { return std::int64_t(p.y()); };
    return (x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a));
}

double lowest(const Mesh& mesh)
{
    double y = 1e300;
    for (Slot v = 0; v < mesh.slots().vertices; ++v)
        if (mesh.isVertex(v))
            y = std::min(y, static_cast<double>(mesh.point(v).y()));
    return y;
}

double highest(const Mesh& mesh)
{
    double y = -1e300;
    for (Slot v = 0; v < mesh.slots().vertices; ++v)
        if (mesh.isVertex(v))
            y = std::max(y, static_cast<double>(mesh.point(v).y()));
    return y;
}

TriangleMesh turned(TriangleMesh mesh, double about, double aside)
{
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(about, core::Vec3::UnitX()) * Eigen::AngleAxisd(aside, core::Vec3::UnitZ()))
            .toRotationMatrix();
    for (Vec3f& p : mesh.points)
        p = (turn * p.cast<double>()).cast<float>();
    return mesh;
}
} // namespace

void TestFlattenBase::polygons_areFilled_data()
{
    QTest::addColumn<std::vector<Loop>>("loops");
    const auto row = [](const char* name, const std::vector<Loop>& loops) { QTest::addRow("%s", name) << loops; };
    row("triangle", {{{0, 0}, {9, 0}, {0, 9}}});
    row("square with points on its sides", {{{0, 0}, {4, 0}, {8, 0}, {8, 8}, {3, 8}, {2, 8}, {0, 8}, {0, 1}}});
    row("ring", {ring(1000, 60, {0, 0}, false), ring(600, 44, {100, 0}, true)});
    row("island in a hole", {ring(1000, 60, {0, 0}, false), ring(600, 44, {0, 0}, true), ring(300, 20, {0, 0}, false)});
    row("many holes", [] {
        std::vector<Loop> loops{{{0, 0}, {1200, 0}, {1200, 1200}, {0, 1200}}};
        for (int i = 0; i < 25; ++i)
            loops.push_back(ring(90, 7 + i % 5, {120 + 240 * (i % 5), 120 + 240 * (i / 5)}, true));
        return loops;
    }());
    row("apart", {ring(1000, 60, {0, 0}, false), ring(1000, 30, {3000, 0}, false)});
    row("comb", [] {
        Loop loop{{0, 0}, {1000, 0}};
        for (int i = 100; i > 0; --i) {
            loop.emplace_back(10 * i, 1000 + i % 7);
            loop.emplace_back(10 * i - 5, 1 + i % 3);
        }
        return std::vector<Loop>{loop};
    }());
    row("star", [] {
        Loop loop;
        for (int i = 0; i < 500; ++i) {
            const double angle = 2 * 3.14159265358979 * i / 500, radius = i % 2 ? 8'000'000 : 3'000'000;
            loop.emplace_back(std::lround(radius * std::cos(angle)), std::lround(radius * std::sin(angle)));
        }
        return std::vector<Loop>{loop};
    }());
}

/// Checks a triangulation: each side of the loops is used once, each other edge twice, every triangle is
/// counter-clockwise, and the areas sum to that of the loops.
void TestFlattenBase::polygons_areFilled()
{
    QFETCH(const std::vector<Loop>, loops);
    std::vector<FlatPoint> points;
    std::vector<std::vector<Slot>> indices;
    std::map<std::pair<Slot, Slot>, int> edges;
    std::int64_t area = 0;
    for (const Loop& loop : loops) {
        std::vector<Slot>& index = indices.emplace_back();
        for (const FlatPoint& p : loop) {
            index.push_back(static_cast<Slot>(points.size()));
            points.push_back(p);
        }
        for (std::size_t i = 0; i < index.size(); ++i) {
            --edges[{index[i], index[(i + 1) % index.size()]}];
            area += twiceArea({0, 0}, loop[i], loop[(i + 1) % loop.size()]);
        }
    }
    const auto filling = core::triangulatePolygon(points, indices);
    QVERIFY(filling);
    for (const Triangle& t : *filling) {
        const std::int64_t part = twiceArea(points[t[0]], points[t[1]], points[t[2]]);
        QVERIFY(part > 0);
        area -= part;
        for (std::size_t i = 0; i < 3; ++i) {
            ++edges[{t[i], t[(i + 1) % 3]}];
            --edges[{t[(i + 1) % 3], t[i]}];
        }
    }
    QCOMPARE(area, 0);
    for (const auto& [edge, count] : edges)
        QVERIFY(count == 0 || count == -1 || count == 1);
    for (const std::vector<Slot>& loop : indices)
        for (std::size_t i = 0; i < loop.size(); ++i)
            QCOMPARE((edges[{loop[i], loop[(i + 1) % loop.size()]}]), 0);
}

void TestFlattenBase::polygons_thatAreNone()
{
    const std::vector<FlatPoint> points{{0, 0}, {8, 8}, {8, 0}, {0, 8}, {4, 4}, {16, 16}};
    QVERIFY(!core::triangulatePolygon(points, {{0, 2, 1, 3, 4, 5}})); // the outline retraces itself
    QVERIFY(!core::triangulatePolygon(points, {{0, 4, 1}}));          // a polygon without area
    QVERIFY(!core::triangulatePolygon(points, {{0, 1, 2}}));          // clockwise, a hole without an outline
    QVERIFY(!core::triangulatePolygon(points, {{0, 2}}));
}

void TestFlattenBase::base_isFlat_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::addColumn<double>("share"); ///< share of the height that is cut off
    const std::pair<const char*, TriangleMesh> models[] = {{"sphere", core::icosphere(3, 1)},
                                                           {"cube", shapes::cube(1)},
                                                           {"torus", shapes::torus()},
                                                           {"turned torus", turned(shapes::torus(), 0.8, 0.6)},
                                                           {"turned cube", turned(shapes::cube(1), 0.5, 0.3)},
                                                           {"bowl", clay::bowl()},
                                                           {"spiral", clay::spiral()},
                                                           {"shell", shapes::nestedSpheres(true)},
                                                           {"two fingers", clay::twoFingers(0.01)},
                                                           {"slab", clay::slab(2, 0.05, 12)}};
    for (const auto& [name, mesh] : models)
        for (const double share : {0.02, 0.25, 0.5, 0.8})
            QTest::addRow("%s, %g", name, share) << mesh << share;
}

void TestFlattenBase::base_isFlat()
{
    QFETCH(const TriangleMesh, shape);
    QFETCH(const double, share);
    const auto mesh = sculptable(shape);
    const std::uint64_t before = mesh->stateHash();
    const double bottom = lowest(*mesh), height = highest(*mesh) - bottom, top = highest(*mesh);
    ModelChange change = applyToCopy(*mesh, FlattenBase{share * height});
    QCOMPARE(static_cast<int>(change.refusal), static_cast<int>(ModelRefusal::None));
    QVERIFY(change.changes);
    mesh->swap(change.delta);
    VERIFY_VALID(*mesh);
    QVERIFY(std::abs(lowest(*mesh) - bottom - share * height) < 40 * mesh->lattice().unit());
    QCOMPARE(highest(*mesh), top);
    const core::PrintReport print = core::checkForPrint({core::extractMesh(*mesh), {}, {}}, {.bed = {}});
    QVERIFY(print.baseArea > 0);
    const std::uint64_t after = mesh->stateHash();
    mesh->swap(change.delta);
    QCOMPARE(mesh->stateHash(), before);
    mesh->swap(change.delta);
    QCOMPARE(mesh->stateHash(), after);
}

/// The removed volume is exactly what was below the cut: a spherical cap.
void TestFlattenBase::base_keepsWhatLiesAbove()
{
    const auto mesh = sculptable(core::icosphere(5, 10));
    ModelChange change = applyToCopy(*mesh, FlattenBase{5});
    mesh->swap(change.delta);
    const core::MeshReport report = core::checkMesh(core::extractMesh(*mesh));
    const double pi = 3.14159265358979, ball = 4.0 / 3 * pi * 1000, cap = pi * 25 * (30 - 5) / 3;
    QVERIFY(std::abs(*report.volume / (ball - cap) - 1) < 0.005);
    const core::PrintReport print = core::checkForPrint({core::extractMesh(*mesh), report, {}}, {.bed = {}});
    QVERIFY(std::abs(print.baseArea / (pi * 75) - 1) < 0.01);
}

void TestFlattenBase::base_ofTheWrongHeightIsRefused()
{
    const auto mesh = sculptable(core::icosphere(3, 10));
    for (const double height : {-1.0, 0.0, 20.0, 25.0, 1e9}) {
        const ModelChange change = applyToCopy(*mesh, FlattenBase{height});
        QCOMPARE(static_cast<int>(change.refusal), static_cast<int>(ModelRefusal::NoBase));
        QVERIFY(!change.changes);
    }
}

void TestFlattenBase::base_ofRandomModels()
{
    std::mt19937 engine(20240812);
    std::uniform_real_distribution<double> angle(-3, 3), share(0.01, 0.97);
    const TriangleMesh sources[] = {core::icosphere(3, 1), shapes::torus(),      clay::bowl(),
                                    shapes::cube(1),       clay::spiral(),       shapes::nestedSpheres(true),
                                    clay::cutRing(0.05),   clay::slab(1, 0.1, 6)};
    int done = 0;
    constexpr int rounds = 120;
    for (int i = 0; i < rounds; ++i) {
        TriangleMesh shape =
            turned(sources[i % std::size(sources)], i % 3 ? angle(engine) : 0, i % 3 ? angle(engine) : 0);
        if (i % 2)
            shape = shapes::noisy(shape, 0.004F, static_cast<unsigned>(i));
        if (!core::checkMesh(shape).printReady())
            continue;
        const auto mesh = sculptable(shape);
        const std::uint64_t before = mesh->stateHash();
        ModelChange change = applyToCopy(*mesh, FlattenBase{share(engine) * (highest(*mesh) - lowest(*mesh))});
        if (change.refusal != ModelRefusal::None)
            continue;
        ++done;
        mesh->swap(change.delta);
        VERIFY_VALID(*mesh);
        mesh->swap(change.delta);
        QCOMPARE(mesh->stateHash(), before);
    }
    QVERIFY2(done > rounds * 0.9, qPrintable(QString::number(done)));
}

void TestFlattenBase::stopped_changesNothing()
{
    const auto mesh = sculptable(core::icosphere(4, 10));
    std::stop_source source;
    source.request_stop();
    const ModelChange change = applyToCopy(*mesh, FlattenBase{5}, {source.get_token(), {}});
    QVERIFY(!change.changes && change.refusal == ModelRefusal::None);
}

void TestFlattenBase::bed_isAtZero_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::addRow("ball") << core::icosphere(3, 10);
    QTest::addRow("above") << shapes::moved(shapes::cube(10), {3, 7.3F, -2});
    QTest::addRow("turned torus") << turned(shapes::torus(), 0.8, 0.6);
}

/// Placing on the bed adds the same amount to the height of each vertex and changes nothing else.
void TestFlattenBase::bed_isAtZero()
{
    QFETCH(const TriangleMesh, shape);
    const auto mesh = sculptable(shape), original = sculptable(shape);
    const double by = lowest(*mesh);
    ModelChange change = applyToCopy(*mesh, PlaceOnBed{});
    QVERIFY(change.changes);
    mesh->swap(change.delta);
    QCOMPARE(lowest(*mesh), 0.0);
    VERIFY_VALID(*mesh);
    for (Slot v = 0; v < mesh->slots().vertices; ++v)
        QCOMPARE(mesh->point(v), Vec3f(original->point(v) - Vec3f(0, static_cast<float>(by), 0)));
    mesh->swap(change.delta);
    QCOMPARE(mesh->stateHash(), original->stateHash());
}

void TestFlattenBase::bed_twiceIsOnce()
{
    const auto mesh = sculptable(core::icosphere(3, 10));
    ModelChange change = applyToCopy(*mesh, PlaceOnBed{});
    mesh->swap(change.delta);
    QVERIFY(!applyToCopy(*mesh, PlaceOnBed{}).changes);
}

FETTLE_TEST(TestFlattenBase, QCoreApplication)

#include "tst_flatten_base.moc"
