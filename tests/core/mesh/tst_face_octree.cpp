#include "core/geometry/box_pairs.h"
#include "core/mesh/face_octree.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <set>

using core::FaceOctree;
using core::LatticeBox;
using core::LatticePoint;
using core::Mesh;
using core::Slot;
using core::TriangleMesh;
using core::Vec3;
using mesh_asserts::sculptable;

namespace
{
LatticeBox randomBox(StrokeFuzzer& random, const Mesh& mesh)
{
    const double reach = mesh.lattice().halfVolume() / mesh.lattice().unit() / 6;
    const auto corner = [&] {
        return Vec3(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach));
    };
    LatticeBox box;
    const Vec3 a = corner();
    const Vec3 b = random.below(2) == 0 ? corner() : Vec3(a + 0.05 * corner());
    box.extend(LatticePoint(a.cast<int>()));
    box.extend(LatticePoint(b.cast<int>()));
    return box;
}

/// Checks a query: each face that meets the box must be found, and only live faces, each once.
void compareWithBruteForce(const Mesh& mesh, const FaceOctree& octree, const LatticeBox& box)
{
    std::set<Slot> found;
    octree.query(box, [&](Slot f) {
        QVERIFY(mesh.isFace(f));
        QVERIFY(found.insert(f).second);
    });
    for (Slot f = 0; f < mesh.slots().faces; ++f)
        QVERIFY(!mesh.isFace(f) || !boxOf(mesh, f).meets(box) || found.contains(f));
}

/// Splits, collapses and moves at random, and updates the octree.
void editSome(StrokeFuzzer& random, Mesh& mesh, FaceOctree& octree)
{
    const Mesh::Mark mark = mesh.mark();
    for (int i = 0; i < 20; ++i) {
        const Slot e = static_cast<Slot>(random.below(mesh.slots().edges));
        if (!mesh.isEdge(e))
            continue;
        const Vec3 middle = 0.5 * (mesh.point(mesh.to(2 * e)) + mesh.point(mesh.to(2 * e + 1))).cast<double>();
        const core::Vec3f p = mesh.lattice().snap(middle + 0.3 * random.uniform() * random.direction());
        const std::uint64_t kind = random.below(3);
        if (kind == 0)
            mesh.splitEdge(e, p);
        else if (kind == 1 && mesh.isCollapseOk(2 * e))
            mesh.collapse(2 * e, p);
        else
            mesh.setPoint(mesh.to(2 * e), p);
    }
    const core::TouchedSlots touched = mesh.touchedSince(mark);
    std::set<Slot> dirty(touched.faces.begin(), touched.faces.end());
    for (Slot v : touched.vertices) {
        if (mesh.isVertex(v))
            mesh.forEachOutgoing(v, [&](Slot h) { dirty.insert(mesh.face(h)); });
    }
    const std::vector<Slot> faces(dirty.begin(), dirty.end());
    octree.update(mesh, faces);
    mesh.commit(mark);
}
} // namespace

class TestFaceOctree : public QObject
{
    Q_OBJECT

    static constexpr std::uint64_t seed = 20240812;

private Q_SLOTS:
    void query_findsWhatBruteForceFinds_data();
    void query_findsWhatBruteForceFinds();
    void edits_areFollowed();
    void undo_isFollowed();
    void wrongPlaces_areNoticed();
    void traverse_seesEveryFaceOnce();
    void boxPairs_agreeWithBruteForce();
};

void TestFaceOctree::query_findsWhatBruteForceFinds_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::newRow("tetrahedron") << shapes::tetrahedron();
    QTest::newRow("sphere") << core::icosphere(3, 1);
    QTest::newRow("torus") << shapes::torus();
    QTest::newRow("thinSlab") << clay::slab(2, 0.01, 10);
    QTest::newRow("farFromTheOrigin") << shapes::moved(core::icosphere(2, 0.1), {7, -7, 7});
}

void TestFaceOctree::query_findsWhatBruteForceFinds()
{
    QFETCH(TriangleMesh, shape);
    const auto mesh = sculptable(shape);
    const FaceOctree octree(*mesh);
    QVERIFY(octree.isConsistent(*mesh));
    StrokeFuzzer random(seed);
    for (int i = 0; i < 1000; ++i)
        compareWithBruteForce(*mesh, octree, randomBox(random, *mesh));
    for (Slot f = 0; f < mesh->slots().faces; f += 7)
        compareWithBruteForce(*mesh, octree, boxOf(*mesh, f));
}

void TestFaceOctree::edits_areFollowed()
{
    const auto mesh = sculptable(shapes::torus());
    FaceOctree octree(*mesh);
    StrokeFuzzer random(seed);
    mesh->beginStroke();
    for (int round = 0; round < 300; ++round) {
        editSome(random, *mesh, octree);
        QVERIFY(octree.isConsistent(*mesh));
        compareWithBruteForce(*mesh, octree, randomBox(random, *mesh));
    }
}

void TestFaceOctree::undo_isFollowed()
{
    const auto mesh = sculptable(shapes::torus());
    FaceOctree octree(*mesh);
    StrokeFuzzer random(seed);
    mesh->beginStroke();
    for (int round = 0; round < 100; ++round)
        editSome(random, *mesh, octree);
    core::MeshDelta delta = mesh->endStroke();
    for (int round = 0; round < 4; ++round) { // undo and redo, twice
        mesh->swap(delta);
        std::vector<Slot> all;
        for (Slot f = 0; f < std::max(mesh->slots().faces, delta.counts.faces); ++f)
            all.push_back(f);
        octree.update(*mesh, all);
        QVERIFY(octree.isConsistent(*mesh));
        compareWithBruteForce(*mesh, octree, randomBox(random, *mesh));
    }
}

void TestFaceOctree::wrongPlaces_areNoticed()
{
    const auto mesh = sculptable(core::icosphere(3, 1));
    const FaceOctree octree(*mesh);
    mesh->beginStroke();
    mesh->setPoint(0, mesh->lattice().snap(Vec3(-5, 5, 5)));
    QVERIFY(!octree.isConsistent(*mesh));
}

void TestFaceOctree::traverse_seesEveryFaceOnce()
{
    const auto mesh = sculptable(clay::bowl());
    const FaceOctree octree(*mesh);
    std::vector<Slot> seen;
    octree.traverse([](const LatticeBox&) { return true; }, [&](Slot f) { seen.push_back(f); });
    std::ranges::sort(seen);
    QCOMPARE(seen.size(), std::size_t(mesh->live().faces));
    QVERIFY(std::ranges::adjacent_find(seen) == seen.end());
}

void TestFaceOctree::boxPairs_agreeWithBruteForce()
{
    StrokeFuzzer random(seed);
    for (int round = 0; round < 300; ++round) {
        const int range = random.below(2) == 0 ? 10 : core::Lattice::limit;
        const auto coordinate = [&] { return static_cast<int>(random.uniform(-1, 1) * range); };
        std::vector<LatticeBox> boxes(random.below(60));
        for (LatticeBox& box : boxes) {
            const LatticePoint a(coordinate(), coordinate(), coordinate());
            box.extend(a);
            box.extend(LatticePoint(a + LatticePoint(coordinate(), coordinate(), coordinate()) / 4));
        }
        const Slot first = static_cast<Slot>(random.below(boxes.size() + 1));
        std::set<std::pair<Slot, Slot>> expected, found;
        for (Slot i = 0; i < first; ++i) {
            for (Slot j = i + 1; j < boxes.size(); ++j) {
                if (boxes[i].meets(boxes[j]))
                    expected.emplace(i, j);
            }
        }
        for (const auto& pair : core::BoxPairs(boxes, first).those([](Slot, Slot) { return true; }))
            QVERIFY(found.insert(pair).second);
        QVERIFY2(found == expected, qPrintable(QString::fromLatin1("seed %1, round %2").arg(seed).arg(round)));
    }
}

FETTLE_TEST(TestFaceOctree)
#include "tst_face_octree.moc"
