#include "core/mesh/mesh_builder.h"
#include "core/sculpt/fuse/cycle_cut.h"
#include "core/sculpt/fuse/ring_join.h"
#include "tests/support/cgal_judge.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

using core::Mesh;
using core::Slot;
using core::Surgery;
using core::Triangle;
using core::TriangleMesh;
using core::Vec3;
using mesh_asserts::eulerNumber;
using mesh_asserts::sculptable;

class TestSurgery : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void joinStars_ofRandomPairs_leavesAManifold();
    void joinStars_ofTwoBalls_makesOne();
    void joinStars_throughASlab_makesAHole();
    void joinStars_ofNeighbours_isNothing();
    void cutCycle_partsAnHourglass();
    void cutCycle_opensAHandle();
    void replaceFaces_canBeTakenBack();
    void aHole_isNotOk();
    void aSideUsedTwice_isNotOk();
    void twoUmbrellas_areNotOkAndSplit();
};

namespace
{
/// Returns two cones joined at a neck of three edges, each corner of which is `neck` from the axis.
TriangleMesh hourglass(double neck)
{
    return clay::revolved(
        {{0, -1, 0}, {0.8, -0.9, 0}, {0.5, -0.4, 0}, {neck, 0, 0}, {0.5, 0.4, 0}, {0.8, 0.9, 0}, {0, 1, 0}}, 3);
}

Slot nearestVertex(const Mesh& mesh, const Vec3& p)
{
    Slot nearest = core::noSlot;
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        const auto away = [&](Slot w) { return (mesh.point(w).cast<double>() - p).squaredNorm(); };
        if (mesh.isVertex(v) && (nearest == core::noSlot || away(v) < away(nearest)))
            nearest = v;
    }
    return nearest;
}

bool isSound(const Mesh& mesh)
{
    const auto verdict = judgedByCgal(core::extractMesh(mesh));
    return verdict && verdict->allWell() && mesh_asserts::brokenLinks(mesh).empty();
}

/// Performs the surgery in a stroke, and checks that undo and redo restore the same bits.
void operate(Mesh& mesh, const Surgery& surgery)
{
    const std::uint64_t before = mesh.stateHash();
    mesh.beginStroke();
    mesh.replaceFaces(surgery);
    core::MeshDelta delta = mesh.endStroke();
    const std::uint64_t after = mesh.stateHash();
    mesh.swap(delta);
    QCOMPARE(mesh.stateHash(), before);
    mesh.swap(delta);
    QCOMPARE(mesh.stateHash(), after);
}
} // namespace

/// Checks connectivity only. A tube changes the Euler number by -2, a closed notch by 0, and each additional part by
/// +2.
void TestSurgery::joinStars_ofRandomPairs_leavesAManifold()
{
    StrokeFuzzer random(20241121);
    int joined = 0, tubes = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto mesh = sculptable(core::icosphere(2, 1));
        const auto vertex = [&] { return static_cast<Slot>(random.below(mesh->slots().vertices)); };
        const Slot p = vertex(), q = vertex();
        const std::optional<Surgery> surgery =
            core::joinStars(*mesh, p, q, i % 2 == 0 ? core::Stepping::Even : core::Stepping::Nearest);
        if (!surgery)
            continue;
        ++joined;
        operate(*mesh, *surgery);
        QCOMPARE(mesh_asserts::brokenLinks(*mesh), std::string());
        const auto euler = eulerNumber(*mesh);
        QVERIFY(euler % 2 == 0);
        tubes += euler == 0;
        QVERIFY(euler == 0 || euler >= 2);
    }
    QVERIFY2(joined > 1000 && tubes > 500, qPrintable(QString("%1 %2").arg(joined).arg(tubes)));
}

void TestSurgery::joinStars_ofTwoBalls_makesOne()
{
    const auto mesh =
        sculptable(shapes::together(core::icosphere(3, 1), shapes::moved(core::icosphere(3, 1), {2.05f, 0, 0})));
    QCOMPARE(eulerNumber(*mesh), 4);
    const auto surgery = core::joinStars(*mesh, nearestVertex(*mesh, {1, 0, 0}), nearestVertex(*mesh, {1.05, 0, 0}));
    QVERIFY(surgery);
    operate(*mesh, *surgery);
    QCOMPARE(eulerNumber(*mesh), 2);
    QVERIFY(isSound(*mesh));
}

void TestSurgery::joinStars_throughASlab_makesAHole()
{
    const auto mesh = sculptable(clay::slab(2, 0.1, 16));
    const auto surgery =
        core::joinStars(*mesh, nearestVertex(*mesh, {0, 0.05, 0}), nearestVertex(*mesh, {0, -0.05, 0}));
    QVERIFY(surgery);
    operate(*mesh, *surgery);
    QCOMPARE(eulerNumber(*mesh), 0);
    QVERIFY(isSound(*mesh));
}

void TestSurgery::joinStars_ofNeighbours_isNothing()
{
    const auto mesh = sculptable(core::icosphere(2, 1));
    for (Slot v = 0; v < mesh->slots().vertices; ++v) {
        QVERIFY(!core::joinStars(*mesh, v, v));
        mesh->forEachOutgoing(v, [&](Slot h) { QVERIFY(!core::joinStars(*mesh, v, mesh->to(h))); });
    }
}

void TestSurgery::cutCycle_partsAnHourglass()
{
    const auto mesh = sculptable(hourglass(0.1));
    Triangle neck{};
    std::size_t found = 0;
    for (Slot v = 0; v < mesh->slots().vertices; ++v) {
        if (mesh->point(v).y() == 0)
            neck[found++] = v;
    }
    QCOMPARE(found, std::size_t(3));
    QVERIFY(!core::isTunnel(*mesh, neck));
    const auto surgery = core::cutCycle(*mesh, neck, core::DrawBack::AlongAxis, 0.1);
    QVERIFY(surgery);
    operate(*mesh, *surgery);
    QCOMPARE(eulerNumber(*mesh), 4);
    QVERIFY(isSound(*mesh));
    QVERIFY(!mesh->isVertex(neck[0]) || mesh->point(neck[0]).y() != 0);
}

/// Cuts the tube of a ring, three edges around, which opens its handle. A tube made by a join never has only three
/// edges around it.
void TestSurgery::cutCycle_opensAHandle()
{
    const TriangleMesh ring = shapes::torus({.around = 12, .across = 3});
    const auto mesh = sculptable(ring);
    QCOMPARE(eulerNumber(*mesh), 0);
    // Finds a cycle of three neighbours around the tube that is not a face.
    std::optional<Surgery> surgery;
    const Slot a = 0;
    mesh->forEachOutgoing(a, [&](Slot h) {
        const Slot b = mesh->to(h);
        mesh->forEachOutgoing(a, [&](Slot g) {
            const Slot c = mesh->to(g);
            const bool isFace = c == mesh->to(mesh->next(h)) || c == mesh->to(mesh->next(h ^ 1));
            if (!surgery && b != c && !isFace && mesh->findHalfedge(b, c) != core::noSlot)
                surgery = core::cutCycle(*mesh, core::Triangle{a, b, c}, core::DrawBack::AlongAxis, 0.05);
        });
    });
    QVERIFY(surgery);
    operate(*mesh, *surgery);
    QCOMPARE(eulerNumber(*mesh), 2);
    QVERIFY(isSound(*mesh));
}

void TestSurgery::replaceFaces_canBeTakenBack()
{
    const auto mesh = sculptable(clay::twoFingers(0.05));
    const std::uint64_t before = mesh->stateHash();
    mesh->beginStroke();
    const Mesh::Mark mark = mesh->mark();
    const auto surgery =
        core::joinStars(*mesh, nearestVertex(*mesh, {-0.025, 0, 0}), nearestVertex(*mesh, {0.025, 0, 0}));
    QVERIFY(surgery);
    mesh->replaceFaces(*surgery);
    QVERIFY(mesh->stateHash() != before);
    mesh->rollback(mark);
    mesh->endStroke();
    QCOMPARE(mesh->stateHash(), before);
}

void TestSurgery::aHole_isNotOk()
{
    const auto mesh = sculptable(core::icosphere(1, 1));
    Surgery surgery;
    QVERIFY(core::isSurgeryOk(*mesh, surgery)); // an empty surgery
    surgery.removed = {0};
    QVERIFY(!core::isSurgeryOk(*mesh, surgery));
    surgery.faces = {mesh->corners(0)};
    QVERIFY(core::isSurgeryOk(*mesh, surgery));
    std::swap(surgery.faces[0][0], surgery.faces[0][1]);
    QVERIFY(!core::isSurgeryOk(*mesh, surgery)); // the new face has reversed orientation
}

void TestSurgery::aSideUsedTwice_isNotOk()
{
    const auto mesh = sculptable(core::icosphere(1, 1));
    Surgery surgery;
    surgery.faces = {mesh->corners(0)}; // the face already exists
    QVERIFY(!core::isSurgeryOk(*mesh, surgery));
    const Triangle t = mesh->corners(0);
    surgery.faces = {{t[2], t[1], t[0]}, t};
    QVERIFY(!core::isSurgeryOk(*mesh, surgery)); // two opposite faces on top of an existing one
}

/// Makes two balls share a vertex by index. The surgery is legal only after one of them has received a copy of the
/// vertex.
void TestSurgery::twoUmbrellas_areNotOkAndSplit()
{
    const auto mesh =
        sculptable(shapes::together(core::icosphere(1, 1), shapes::moved(core::icosphere(1, 1), {3, 0, 0})));
    const Slot p = nearestVertex(*mesh, {1, 0, 0}), q = nearestVertex(*mesh, {2, 0, 0});
    Surgery surgery;
    surgery.nearby = p;
    mesh->forEachOutgoing(q, [&](Slot h) {
        surgery.removed.push_back(mesh->face(h));
        surgery.faces.push_back({p, mesh->to(h), mesh->to(mesh->next(h))});
    });
    QVERIFY(!core::isSurgeryOk(*mesh, surgery));
    core::splitUmbrellas(*mesh, surgery, 0.25);
    QVERIFY(core::isSurgeryOk(*mesh, surgery));
    QCOMPARE(surgery.vertices.size(), std::size_t(1));
    operate(*mesh, surgery);
    QCOMPARE(eulerNumber(*mesh), 4);
    QCOMPARE(mesh_asserts::brokenLinks(*mesh), std::string());
}

FETTLE_TEST(TestSurgery)
#include "tst_surgery.moc"
