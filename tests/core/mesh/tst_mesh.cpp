#include "core/mesh/mesh.h"
#include "core/mesh/mesh_hash.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <sstream>

using core::Mesh;
using core::MeshDelta;
using core::noSlot;
using core::Rgb;
using core::Slot;
using core::TriangleMesh;
using core::Vec3;
using core::Vec3f;
using mesh_asserts::brokenLinks;
using mesh_asserts::sculptable;

namespace
{
Slot randomLive(StrokeFuzzer& random, Slot count, const auto& isLive)
{
    while (true) {
        const Slot slot = static_cast<Slot>(random.below(count));
        if (isLive(slot))
            return slot;
    }
}

Slot randomEdge(StrokeFuzzer& random, const Mesh& mesh)
{
    return randomLive(random, mesh.slots().edges, [&](Slot e) { return mesh.isEdge(e); });
}

Vec3f midpoint(const Mesh& mesh, Slot e)
{
    const Vec3 sum = mesh.point(mesh.to(2 * e)).cast<double>() + mesh.point(mesh.to(2 * e + 1)).cast<double>();
    return mesh.lattice().snap(0.5 * sum);
}

/// Makes one random edit, or none if it is illegal. It may spoil the geometry, because only links are tested.
void editOnce(StrokeFuzzer& random, Mesh& mesh)
{
    const Slot e = randomEdge(random, mesh);
    const Slot h = 2 * e + static_cast<Slot>(random.below(2));
    switch (random.below(8)) {
    case 0:
    case 1:
        mesh.splitEdge(e, midpoint(mesh, e));
        break;
    case 2:
    case 3:
    case 4:
        if (mesh.isCollapseOk(h))
            mesh.collapse(h, midpoint(mesh, e));
        break;
    case 5:
    case 6:
        if (mesh.isFlipOk(e))
            mesh.flip(e);
        break;
    default:
        mesh.setPoint(mesh.to(h), midpoint(mesh, e));
        mesh.setColor(mesh.from(h), {static_cast<std::uint8_t>(random.below(256)), 7, 9});
    }
}

/// Makes a stroke of nested marks, some of which are rolled back.
MeshDelta randomStroke(StrokeFuzzer& random, Mesh& mesh, int edits)
{
    mesh.beginStroke();
    for (int i = 0; i < edits;) {
        const Mesh::Mark mark = mesh.mark();
        for (const int end = i + 1 + static_cast<int>(random.below(20)); i < end; ++i)
            editOnce(random, mesh);
        if (random.below(3) == 0)
            mesh.rollback(mark);
        else
            mesh.commit(mark);
    }
    return mesh.endStroke();
}
} // namespace

class TestMesh : public QObject
{
    Q_OBJECT

    static constexpr std::uint64_t seed = 20240812;

private Q_SLOTS:
    void build_linksTheShape_data();
    void build_linksTheShape();
    void randomEdits_keepTheLinks_data() { build_linksTheShape_data(); }
    void randomEdits_keepTheLinks();
    void rollback_restoresTheStateOfEachNestedMark();
    void rollback_toTheSameMarkTwice();
    void commit_keepsWhatTheStrokeTouched();
    void touchedSince_namesEachElementOnce();
    void swap_undoesAndRedoesBitForBit();
    void undo_thenAnotherStroke_isAsIfItHadNeverBeen();
    void emptyStroke_hasAnEmptyDelta();
    void delta_survivesWritingAndReading();
    void meshHash_isThatOfTheFaces();
    void meshHash_doesNotDependOnTheOrder();
    void meshHash_seesColoursAndTakesMinusZeroAsZero();
    void collapse_refusesTheTetrahedron();
    void collapse_atValenceThree();
    void collapse_meansColours();
    void collapse_refusesABrokenLinkCondition();
    void flip_refusesNeighbours();
    void split_givesTheMeanColour();
    void findHalfedge_findsNeighboursOnly();
};

void TestMesh::build_linksTheShape_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::newRow("tetrahedron") << shapes::tetrahedron();
    QTest::newRow("cube") << shapes::cube(2);
    QTest::newRow("sphere") << core::icosphere(2, 1);
    QTest::newRow("torus") << shapes::torus();
    QTest::newRow("nestedShells") << shapes::nestedSpheres(true);
    QTest::newRow("thinSlab") << clay::slab(2, 0.05, 4);
    QTest::newRow("bowl") << clay::bowl();
    QTest::newRow("twoFingers") << clay::twoFingers(0.01);
}

void TestMesh::build_linksTheShape()
{
    QFETCH(TriangleMesh, shape);
    const auto mesh = sculptable(shape);
    VERIFY_VALID(*mesh);
    QCOMPARE(mesh->live().vertices, static_cast<Slot>(shape.points.size()));
    QCOMPARE(mesh->live().faces, static_cast<Slot>(shape.triangles.size()));
    for (Slot f = 0; f < mesh->slots().faces; ++f)
        QVERIFY(mesh->corners(f) == shape.triangles[f]);
}

void TestMesh::randomEdits_keepTheLinks()
{
    QFETCH(TriangleMesh, shape);
    const auto mesh = sculptable(shape);
    const std::int64_t euler = mesh_asserts::eulerNumber(*mesh);
    StrokeFuzzer random(seed);
    mesh->beginStroke();
    for (int i = 0; i < 2000; ++i) {
        editOnce(random, *mesh);
        VERIFY_LINKED(*mesh);
        QCOMPARE(mesh_asserts::eulerNumber(*mesh), euler);
        if (i % 500 == 0) {
            const std::optional<CgalVerdict> verdict = judgedByCgal(mesh_asserts::surfaceOf(*mesh));
            QVERIFY(verdict && verdict->closed); // manifold and oriented, regardless of vertex positions
        }
    }
    QVERIFY(!mesh->endStroke().empty());
}

void TestMesh::rollback_restoresTheStateOfEachNestedMark()
{
    const auto mesh = sculptable(shapes::torus());
    StrokeFuzzer random(seed);
    mesh->beginStroke();
    for (int round = 0; round < 100; ++round) {
        std::vector<std::pair<Mesh::Mark, std::uint64_t>> marks;
        for (std::uint64_t depth = 1 + random.below(6); depth > 0; --depth) {
            marks.emplace_back(mesh->mark(), mesh->stateHash());
            for (std::uint64_t edits = random.below(30); edits > 0; --edits)
                editOnce(random, *mesh);
        }
        while (!marks.empty()) {
            const std::size_t to = random.below(marks.size());
            mesh->rollback(marks[to].first);
            QCOMPARE(mesh->stateHash(), marks[to].second);
            marks.resize(to);
        }
        VERIFY_LINKED(*mesh);
        for (int i = 0; i < 5; ++i) // gives each round a different start state
            editOnce(random, *mesh);
    }
    MeshDelta delta = mesh->endStroke();
    const std::uint64_t end = mesh->stateHash();
    QCOMPARE(mesh->meshHash(), wholeHash(*mesh));
    mesh->swap(delta);
    QCOMPARE(mesh->stateHash(), sculptable(shapes::torus())->stateHash());
    mesh->swap(delta);
    QCOMPARE(mesh->stateHash(), end);
}

void TestMesh::rollback_toTheSameMarkTwice()
{
    const auto mesh = sculptable(core::icosphere(2, 1));
    StrokeFuzzer random(seed);
    const std::uint64_t start = mesh->stateHash();
    mesh->beginStroke();
    const Mesh::Mark mark = mesh->mark();
    for (int round = 0; round < 20; ++round) {
        for (int i = 0; i < 40; ++i)
            editOnce(random, *mesh);
        mesh->rollback(mark);
        QCOMPARE(mesh->stateHash(), start);
    }
    QVERIFY(mesh->endStroke().empty());
    QCOMPARE(mesh->stateHash(), start);
}

void TestMesh::commit_keepsWhatTheStrokeTouched()
{
    const auto mesh = sculptable(core::icosphere(2, 1));
    mesh->beginStroke();
    for (int i = 0; i < 50; ++i) {
        const Mesh::Mark mark = mesh->mark();
        mesh->setPoint(5, mesh->lattice().snap(Vec3(0.01 * i, 0, 1)));
        mesh->setPoint(static_cast<Slot>(10 + i % 2), mesh->lattice().snap(Vec3(0, 0.01 * i, 1)));
        mesh->commit(mark);
    }
    QCOMPARE(mesh->endStroke().vertices.size(), std::size_t(3)); // one image per element, however often it was changed
}

void TestMesh::touchedSince_namesEachElementOnce()
{
    const auto mesh = sculptable(shapes::torus());
    StrokeFuzzer random(seed);
    mesh->beginStroke();
    for (int round = 0; round < 50; ++round) {
        struct Before
        {
            bool live;
            Vec3f point;
        };
        std::vector<Before> vertices;
        std::vector<core::Triangle> faces;
        for (Slot v = 0; v < mesh->slots().vertices; ++v)
            vertices.push_back({mesh->isVertex(v), mesh->point(v)});
        for (Slot f = 0; f < mesh->slots().faces; ++f)
            faces.push_back(mesh->corners(f));

        const Mesh::Mark mark = mesh->mark();
        for (int i = 0; i < 10; ++i)
            editOnce(random, *mesh);
        const core::TouchedSlots touched = mesh->touchedSince(mark);
        const auto isTouched = [](const std::vector<Slot>& slots, Slot slot) {
            return std::ranges::count(slots, slot) == 1;
        };
        for (Slot v = 0; v < mesh->slots().vertices; ++v) {
            const bool same = v < vertices.size() && vertices[v].live == mesh->isVertex(v) &&
                              (!mesh->isVertex(v) || vertices[v].point == mesh->point(v));
            QVERIFY(same || isTouched(touched.vertices, v));
            QVERIFY(std::ranges::count(touched.vertices, v) <= 1);
        }
        for (Slot f = 0; f < mesh->slots().faces; ++f) {
            QVERIFY((f < faces.size() && faces[f] == mesh->corners(f)) || isTouched(touched.faces, f));
            QVERIFY(std::ranges::count(touched.faces, f) <= 1);
        }
        mesh->commit(mark);
    }
    mesh->endStroke();
}

void TestMesh::swap_undoesAndRedoesBitForBit()
{
    const auto mesh = sculptable(shapes::torus());
    StrokeFuzzer random(seed);
    std::vector<std::uint64_t> states = {mesh->stateHash()}, hashes = {mesh->meshHash()};
    std::vector<MeshDelta> deltas;
    for (int i = 0; i < 30; ++i) {
        deltas.push_back(randomStroke(random, *mesh, 100));
        states.push_back(mesh->stateHash());
        hashes.push_back(mesh->meshHash());
    }
    std::size_t at = deltas.size();
    for (int step = 0; step < 300; ++step) {
        const bool undo = at > 0 && (at == deltas.size() || random.below(2) == 0);
        mesh->swap(deltas[undo ? --at : at++]);
        QCOMPARE(mesh->stateHash(), states[at]);
        QCOMPARE(mesh->meshHash(), hashes[at]);
        QCOMPARE(mesh->meshHash(), wholeHash(*mesh));
        VERIFY_LINKED(*mesh);
    }
}

void TestMesh::undo_thenAnotherStroke_isAsIfItHadNeverBeen()
{
    for (std::uint64_t round = 0; round < 20; ++round) {
        const auto detour = sculptable(shapes::torus()), direct = sculptable(shapes::torus());
        StrokeFuzzer a(seed + round), b(seed + 1000 + round), sameB(seed + 1000 + round);
        MeshDelta delta = randomStroke(a, *detour, 200);
        detour->swap(delta);
        randomStroke(b, *detour, 200);
        randomStroke(sameB, *direct, 200);
        QCOMPARE(detour->stateHash(), direct->stateHash());
    }
}

void TestMesh::emptyStroke_hasAnEmptyDelta()
{
    const auto mesh = sculptable(shapes::cube(2));
    const std::uint64_t state = mesh->stateHash();
    mesh->beginStroke();
    QVERIFY(mesh->strokeOpen());
    MeshDelta delta = mesh->endStroke();
    QVERIFY(delta.empty() && !mesh->strokeOpen());
    mesh->swap(delta);
    QCOMPARE(mesh->stateHash(), state);
}

void TestMesh::delta_survivesWritingAndReading()
{
    const auto mesh = sculptable(shapes::torus());
    const std::uint64_t start = mesh->stateHash();
    StrokeFuzzer random(seed);
    const MeshDelta delta = randomStroke(random, *mesh, 200);
    const std::uint64_t end = mesh->stateHash();
    std::stringstream stream;
    delta.write(stream);
    MeshDelta read = MeshDelta::read(stream);
    mesh->swap(read);
    QCOMPARE(mesh->stateHash(), start);
    mesh->swap(read);
    QCOMPARE(mesh->stateHash(), end);
    MeshDelta cut = MeshDelta::read(stream); // the stream is at its end, so reading fails
    QVERIFY(!stream && cut.empty());
}

void TestMesh::meshHash_isThatOfTheFaces()
{
    for (const TriangleMesh& shape : {core::icosphere(2, 1), clay::bowl(), shapes::nestedSpheres(true)}) {
        const auto mesh = sculptable(shape);
        StrokeFuzzer random(seed);
        for (int i = 0; i < 50; ++i) {
            QCOMPARE(mesh->meshHash(), wholeHash(*mesh));
            randomStroke(random, *mesh, 40);
        }
    }
}

void TestMesh::meshHash_doesNotDependOnTheOrder()
{
    StrokeFuzzer random(seed);
    const TriangleMesh shape = clay::bowl();
    const std::uint64_t hash = sculptable(shape)->meshHash();
    for (int i = 0; i < 10; ++i)
        QCOMPARE(sculptable(shapes::shuffled(shape, random))->meshHash(), hash);
    QVERIFY(sculptable(shapes::reversed(shape))->meshHash() != hash);
}

void TestMesh::meshHash_seesColoursAndTakesMinusZeroAsZero()
{
    const auto mesh = sculptable(shapes::cube(2));
    const std::uint64_t hash = mesh->meshHash();
    mesh->beginStroke();
    mesh->setColor(3, {1, 2, 3});
    MeshDelta delta = mesh->endStroke();
    QVERIFY(mesh->meshHash() != hash);
    QCOMPARE(mesh->meshHash(), wholeHash(*mesh));
    QVERIFY(core::hashCorner({-0.0f, 1, 2}, {}) == core::hashCorner({0.0f, 1, 2}, {}));
}

void TestMesh::collapse_refusesTheTetrahedron()
{
    const auto mesh = sculptable(shapes::tetrahedron());
    for (Slot h = 0; h < 12; ++h)
        QVERIFY(!mesh->isCollapseOk(h));
    for (Slot e = 0; e < 6; ++e)
        QVERIFY(!mesh->isFlipOk(e));
}

void TestMesh::collapse_atValenceThree()
{
    const auto mesh = sculptable(core::icosphere(1, 1));
    mesh->beginStroke();
    const Slot m = mesh->splitEdge(0, midpoint(*mesh, 0)); // `m` has valence 4
    Slot spoke = mesh->outgoing(m);
    while (!mesh->isFlipOk(spoke / 2))
        spoke = mesh->rotate(spoke);
    mesh->flip(spoke / 2); // `m` has valence 3
    QCOMPARE(mesh->valence(m), 3u);
    mesh->forEachOutgoing(m, [&](Slot h) {
        QVERIFY(!mesh->isCollapseOk(mesh->next(h))); // the collapse would leave a vertex of valence 2
        QVERIFY(!mesh->isFlipOk(h / 2));
    });
    for (Slot side : {0u, 1u}) { // collapses `m` into its neighbour, then the neighbour into `m`
        const Mesh::Mark mark = mesh->mark();
        const Slot h = mesh->outgoing(m) ^ side, ring = mesh->to(mesh->outgoing(m));
        const unsigned before = mesh->valence(ring);
        QVERIFY(mesh->isCollapseOk(h));
        mesh->collapse(h, mesh->point(ring));
        VERIFY_LINKED(*mesh);
        QCOMPARE(mesh->valence(mesh->isVertex(m) ? m : ring), before - 1);
        mesh->rollback(mark);
    }
    mesh->endStroke();
}

/// The remaining vertex gets colour and mask interpolated at its position on the collapsed edge.
void TestMesh::collapse_meansColours()
{
    for (const double share : {0.0, 0.25, 0.5, 1.0}) {
        const auto mesh = sculptable(core::icosphere(2, 1));
        Slot h = 0;
        while (!mesh->isCollapseOk(h))
            ++h;
        const Slot from = mesh->from(h), to = mesh->to(h);
        mesh->beginStroke();
        mesh->setColor(from, {0, 100, 200});
        mesh->setColor(to, {200, 100, 0});
        mesh->setMask(to, 80);
        const core::Vec3f p = mesh->point(from) + float(share) * (mesh->point(to) - mesh->point(from));
        mesh->collapse(h, mesh->lattice().snap(p.cast<double>()));
        const core::Rgb color = mesh->color(to);
        QVERIFY(std::abs(color.r - 200 * share) < 1.5 && color.g == 100 && std::abs(color.b - 200 * (1 - share)) < 1.5);
        QVERIFY(std::abs(mesh->mask(to) - 80 * share) < 1.5);
        mesh->endStroke();
    }
}

void TestMesh::collapse_refusesABrokenLinkCondition()
{
    // Each ring of three vertices around the tube is a closed triangle that is not a face.
    const auto mesh = sculptable(shapes::torus({3, 1, 8, 3}));
    int refused = 0;
    for (Slot h = 0; h < 2 * mesh->slots().edges; ++h) {
        int common = 0;
        mesh->forEachOutgoing(mesh->from(h),
                              [&](Slot g) { common += mesh->findHalfedge(mesh->to(h), mesh->to(g)) != noSlot; });
        if (common > 2) {
            QVERIFY(!mesh->isCollapseOk(h));
            ++refused;
        }
    }
    QVERIFY(refused > 0);
}

void TestMesh::flip_refusesNeighbours()
{
    const auto mesh = sculptable(shapes::cube(2));
    for (Slot e = 0; e < mesh->slots().edges; ++e) {
        const Slot c = mesh->to(mesh->next(2 * e)), d = mesh->to(mesh->next(2 * e + 1));
        if (mesh->findHalfedge(c, d) != noSlot)
            QVERIFY(!mesh->isFlipOk(e));
    }
}

void TestMesh::split_givesTheMeanColour()
{
    const auto mesh = sculptable(shapes::cube(2));
    mesh->beginStroke();
    mesh->setColor(mesh->from(0), {10, 20, 255});
    mesh->setColor(mesh->to(0), {20, 21, 255});
    const Slot m = mesh->splitEdge(0, midpoint(*mesh, 0));
    QVERIFY(mesh->color(m) == (Rgb{15, 21, 255}));
    mesh->endStroke();
    VERIFY_VALID(*mesh);
}

void TestMesh::findHalfedge_findsNeighboursOnly()
{
    const auto mesh = sculptable(core::icosphere(1, 1));
    for (Slot a = 0; a < mesh->slots().vertices; ++a) {
        for (Slot b = 0; b < mesh->slots().vertices; ++b) {
            bool neighbours = false;
            mesh->forEachOutgoing(a, [&](Slot h) { neighbours = neighbours || mesh->to(h) == b; });
            const Slot h = mesh->findHalfedge(a, b);
            QCOMPARE(h != noSlot, neighbours);
            QVERIFY(h == noSlot || (mesh->from(h) == a && mesh->to(h) == b));
        }
    }
}

FETTLE_TEST(TestMesh)
#include "tst_mesh.moc"
