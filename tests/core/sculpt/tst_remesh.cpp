#include "core/sculpt/remesh/remesh.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <iostream>

using core::EdgeBounds;
using core::FaceOctree;
using core::Mesh;
using core::MeshEditor;
using core::Region;
using core::RemeshCounts;
using core::Slot;
using core::Vec3;
using mesh_asserts::sculptable;
using mesh_asserts::volumeOf;

namespace
{
/// A mesh in an open stroke, with the vertices of a ball selected.
struct SelectedMesh
{
    std::unique_ptr<Mesh> mesh;
    MeshEditor edit;
    Region region;
    std::vector<Slot> candidates;
    core::Sphere ball;

    SelectedMesh(core::TriangleMesh shape, const core::Sphere& brush)
        : mesh(sculptable(std::move(shape)))
        , edit(*mesh)
        , ball(brush)
    {
        const FaceOctree octree(*mesh);
        selectSphere(region, candidates, *mesh, octree, ball);
        mesh->beginStroke();
    }

    double length(Slot e) const
    {
        return (mesh->point(mesh->to(2 * e)) - mesh->point(mesh->to(2 * e + 1))).cast<double>().norm();
    }

    double shareAtLeast(double least) const
    {
        const std::vector<Slot> edges = innerEdges();
        const auto longEnough = std::ranges::count_if(edges, [&](Slot e) { return length(e) >= least; });
        return static_cast<double>(longEnough) / static_cast<double>(edges.size());
    }

    std::vector<Slot> innerEdges() const
    {
        std::vector<Slot> edges;
        for (Slot e = 0; e < mesh->slots().edges; ++e) {
            if (mesh->isEdge(e) && region.contains(mesh->to(2 * e)) && region.contains(mesh->to(2 * e + 1)))
                edges.push_back(e);
        }
        return edges;
    }
};

Vec3 areaVector(const Mesh& mesh, Slot f)
{
    const core::Triangle& t = mesh.corners(f);
    const Vec3 a = mesh.point(t[0]).cast<double>(), b = mesh.point(t[1]).cast<double>(),
               c = mesh.point(t[2]).cast<double>();
    return 0.5 * (b - a).cross(c - a);
}

double smallestAngle(const Mesh& mesh, Slot f)
{
    const core::Triangle& t = mesh.corners(f);
    double smallest = 180;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 p = mesh.point(t[i]).cast<double>();
        const Vec3 u = (mesh.point(t[(i + 1) % 3]).cast<double>() - p).normalized();
        const Vec3 v = (mesh.point(t[(i + 2) % 3]).cast<double>() - p).normalized();
        smallest = std::min(smallest, std::acos(std::clamp(u.dot(v), -1.0, 1.0)) * 57.29577951308232);
    }
    return smallest;
}

const core::Sphere brush = {{0, 0, 1}, 0.6};

/// Returns a ball of radius 1 with noise of up to 0.008 in each coordinate. Its mean edge length is 0.07.
core::TriangleMesh noisyBall()
{
    return shapes::noisy(core::icosphere(4, 1), 0.008f, 11);
}
} // namespace

class TestRemesh : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void optimise_boundsTheEdges_data();
    void optimise_boundsTheEdges();
    void eachOperation_isLegal_data() { optimise_boundsTheEdges_data(); }
    void eachOperation_isLegal();
    void refusedOperations_leaveTheMesh();
    void optimise_keepsTheShape_data() { optimise_boundsTheEdges_data(); }
    void optimise_keepsTheShape();
    void optimise_carriesColoursAndPlans();
    void optimise_leavesTheRestAlone();
    void sparedVertices_stayAsTheyAre();
    void again_isNearlyIdle();
    void hugeTask_isCapped();
    void splitLongEdges_onlySplits();
    void refine_makesFacesUnderTheBrushFine();
    void refine_reachesABrushInsideOneFace();
};

void TestRemesh::optimise_boundsTheEdges_data()
{
    QTest::addColumn<double>("detail");
    QTest::newRow("finer") << 0.04;
    QTest::newRow("alike") << 0.075;
    QTest::newRow("coarser") << 0.2;
}

void TestRemesh::optimise_boundsTheEdges()
{
    QFETCH(double, detail);
    SelectedMesh s(noisyBall(), brush);
    const RemeshCounts counts = optimise(s.edit, s.region, {detail, detail / 2});
    QVERIFY(!counts.capped);
    VERIFY_VALID(*s.mesh);
    const std::vector<Slot> edges = s.innerEdges();
    for (Slot e : edges)
        QVERIFY(s.length(e) <= detail);
    const double share = s.shareAtLeast(detail / 2);
    std::vector<double> angles;
    for (Slot f = 0; f < s.mesh->slots().faces; ++f) {
        const core::Triangle& t = s.mesh->corners(f);
        if (s.mesh->isFace(f) && s.region.contains(t[0]) && s.region.contains(t[1]) && s.region.contains(t[2]))
            angles.push_back(smallestAngle(*s.mesh, f));
    }
    std::ranges::sort(angles);
    std::cout << QTest::currentDataTag() << ": " << edges.size() << " edges, " << 100 * share
              << " % at least d long, 1st percentile of smallest angles " << angles[angles.size() / 100] << " degrees; "
              << counts.splits << " splits, " << counts.collapses << " collapses, " << counts.flips << " flips"
              << std::endl;
    QVERIFY(share >= 0.95);
    QVERIFY(angles[angles.size() / 100] >= 20);
}

void TestRemesh::eachOperation_isLegal()
{
    QFETCH(double, detail);
    SelectedMesh s(noisyBall(), brush);
    Mesh& mesh = *s.mesh;
    bool legal = true;
    int operations = 0;
    const auto judged = [&](const std::function<void()>& operation) {
        const Mesh::Mark mark = mesh.mark();
        operation();
        ++operations;
        const core::TouchedSlots touched = mesh.touchedSince(mark);
        for (Slot v : touched.vertices) {
            if (!mesh.isVertex(v))
                continue;
            legal = legal && mesh.valence(v) >= 3;
            mesh.forEachOutgoing(v, [&](Slot h) { // the model is a ball, so no face may turn inwards
                const core::Triangle& t = mesh.corners(mesh.face(h));
                const Vec3 center = (mesh.point(t[0]) + mesh.point(t[1]) + mesh.point(t[2])).cast<double>() / 3;
                legal = legal && areaVector(mesh, mesh.face(h)).dot(center) > 0;
            });
        }
        if (operations % 16 == 0)
            legal = legal && mesh_asserts::brokenLinks(mesh).empty();
        mesh.commit(mark);
        return true;
    };
    MeshEditor edit(mesh, judged);
    optimise(edit, s.region, {detail, detail / 2});
    QVERIFY(operations > 50);
    QVERIFY(legal);
    VERIFY_VALID(mesh);
}

void TestRemesh::refusedOperations_leaveTheMesh()
{
    SelectedMesh s(noisyBall(), brush);
    const std::uint64_t before = s.mesh->stateHash();
    const auto refuse = [&](const std::function<void()>& operation) {
        const Mesh::Mark mark = s.mesh->mark();
        operation();
        s.mesh->rollback(mark);
        return false;
    };
    const Slot selected = s.region.size();
    MeshEditor edit(*s.mesh, refuse);
    const RemeshCounts counts = optimise(edit, s.region, {0.06, 0.05});
    QVERIFY(!counts.any());
    QCOMPARE(s.mesh->stateHash(), before);
    QCOMPARE(s.region.size(), selected);
}

void TestRemesh::optimise_keepsTheShape()
{
    QFETCH(double, detail);
    SelectedMesh s(core::icosphere(4, 1), brush);
    const double before = volumeOf(*s.mesh);
    optimise(s.edit, s.region, {detail, detail / 2});
    QVERIFY(std::abs(volumeOf(*s.mesh) - before) < 0.01 * before);
    for (Slot v = 0; v < s.mesh->slots().vertices; ++v) {
        // midpoints of chords are detail^2 / 8 inside the sphere, and errors of repeated splits add up
        if (s.mesh->isVertex(v))
            QVERIFY(std::abs(s.mesh->point(v).cast<double>().norm() - 1) < detail * detail + 0.004);
    }
}

void TestRemesh::optimise_carriesColoursAndPlans()
{
    for (double detail : {0.04, 0.2}) {
        SelectedMesh s(noisyBall(), brush);
        for (Slot v : s.region.slots()) {
            s.mesh->setColor(v, {10, 20, 30});
            s.region.setPlan(v, {0, 0, 1});
        }
        QVERIFY(optimise(s.edit, s.region, {detail, detail / 2}).any());
        s.region.forEach([&](Slot v) {
            QVERIFY(s.mesh->isVertex(v));
            QVERIFY(s.mesh->color(v) == (core::Rgb{10, 20, 30}));
            QVERIFY(s.region.plan(v) == Vec3(0, 0, 1));
        });
    }
}

void TestRemesh::optimise_leavesTheRestAlone()
{
    SelectedMesh s(noisyBall(), brush);
    std::vector<core::Vec3f> before;
    for (Slot v = 0; v < s.mesh->slots().vertices; ++v)
        before.push_back(s.mesh->point(v));
    const std::vector<Slot> selected = s.region.slots();
    optimise(s.edit, s.region, {0.2, 0.1});
    for (Slot v = 0; v < before.size(); ++v) {
        if (!std::ranges::binary_search(selected, v))
            QVERIFY(s.mesh->isVertex(v) && s.mesh->point(v) == before[v]);
    }
}

void TestRemesh::sparedVertices_stayAsTheyAre()
{
    SelectedMesh s(noisyBall(), brush);
    core::SlotSet frozen;
    std::vector<core::Vec3f> before;
    s.region.forEach([&](Slot v) {
        if (s.mesh->point(v).x() > 0.1f) {
            frozen.add(v);
            before.push_back(s.mesh->point(v));
        }
    });
    MeshEditor edit(*s.mesh, {}, nullptr, &frozen);
    QVERIFY(optimise(edit, s.region, {0.2, 0.1}).collapses > 0);
    for (std::size_t i = 0; i < before.size(); ++i)
        QVERIFY(s.mesh->isVertex(frozen.slots()[i]) && s.mesh->point(frozen.slots()[i]) == before[i]);
}

void TestRemesh::again_isNearlyIdle()
{
    SelectedMesh s(noisyBall(), brush);
    const EdgeBounds bounds = {0.1, 0.05};
    const RemeshCounts first = optimise(s.edit, s.region, bounds);
    RemeshCounts last;
    for (int i = 0; i < 5; ++i)
        last = optimise(s.edit, s.region, bounds);
    const auto all = [](const RemeshCounts& c) { return c.splits + c.collapses + c.flips; };
    QVERIFY2(all(last) * 10 <= all(first), qPrintable(QString::number(all(last))));
}

void TestRemesh::hugeTask_isCapped()
{
    SelectedMesh s(core::icosphere(1, 1), {{0, 0, 0}, 2});
    const RemeshCounts counts = optimise(s.edit, s.region, {0.002, 0.001});
    QVERIFY(counts.capped);
    VERIFY_VALID(*s.mesh);
}

void TestRemesh::splitLongEdges_onlySplits()
{
    SelectedMesh s(noisyBall(), brush);
    const RemeshCounts counts = splitLongEdges(s.edit, s.region, {0.05, 0.025});
    QVERIFY(counts.splits > 0 && counts.collapses == 0 && counts.flips == 0);
    for (Slot e : s.innerEdges())
        QVERIFY(s.length(e) <= 0.05);
    VERIFY_VALID(*s.mesh);
}

void TestRemesh::refine_makesFacesUnderTheBrushFine()
{
    SelectedMesh s(core::icosphere(2, 1), brush);
    const double detail = 0.1;
    const RemeshCounts counts = refine(s.edit, s.region, s.candidates, s.ball, {detail, detail / 2});
    QVERIFY(counts.splits > 0 && !counts.capped);
    for (Slot e : s.innerEdges())
        QVERIFY(s.length(e) <= detail);
    for (Slot v = 0; v < s.mesh->slots().vertices; ++v) { // every vertex in the ball must be selected
        const bool inside =
            s.mesh->isVertex(v) && (s.mesh->point(v).cast<double>() - brush.center).norm() <= brush.radius;
        QCOMPARE(s.mesh->isVertex(v) && s.region.contains(v), inside);
    }
    VERIFY_VALID(*s.mesh);
}

void TestRemesh::refine_reachesABrushInsideOneFace()
{
    SelectedMesh s(shapes::cube(20), {{3, 2, 10}, 1}); // no vertex is near the brush
    QVERIFY(s.region.empty());
    const EdgeBounds bounds = core::edgeBounds(1, 1);
    refine(s.edit, s.region, s.candidates, s.ball, bounds);
    QVERIFY(s.region.size() > 20);
    for (Slot e : s.innerEdges())
        QVERIFY(s.length(e) <= bounds.detail);
    VERIFY_VALID(*s.mesh);
}

FETTLE_TEST(TestRemesh)
#include "tst_remesh.moc"
