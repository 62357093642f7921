// Tests the local check on random changes against exact tests of all pairs and against CGAL, and certificates against
// exact tests of pairs. Tests also defects that no pair of faces shows.

#include "core/geometry/triangle_intersection.h"
#include "core/sculpt/verify/verifier.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <iostream>

using core::FaceOctree;
using core::Lattice;
using core::LatticePoint;
using core::LatticePredicates;
using core::Mesh;
using core::PatchFace;
using core::Slot;
using core::TriangleMesh;
using core::Vec3;
using core::Vec3f;
using core::Verifier;
using core::VerifyResult;
using mesh_asserts::sculptable;

namespace
{
constexpr std::uint64_t seed = 20240812;

/// A mesh with its octree and its verifier, as the engine combines them.
struct Subject
{
    std::unique_ptr<Mesh> mesh;
    FaceOctree octree;
    Verifier verifier;

    explicit Subject(std::unique_ptr<Mesh> m) : mesh(std::move(m)), octree(*mesh) { mesh->beginStroke(); }

    VerifyResult verify(const Mesh::Mark& mark) { return verifier.verify(*mesh, octree, mesh->touchedSince(mark)); }
    void index(const Mesh::Mark& mark)
    {
        octree.update(*mesh, mesh->touchedSince(mark).faces);
        octree.update(*mesh, verifier.dirtyFaces());
    }
};

Vec3f clamped(const Lattice& lattice, const Vec3& p)
{
    const double wall = lattice.halfVolume();
    return lattice.snap(p.cwiseMax(Vec3::Constant(-wall)).cwiseMin(Vec3::Constant(wall)));
}

Slot randomVertex(StrokeFuzzer& random, const Mesh& mesh)
{
    while (true) {
        const Slot v = static_cast<Slot>(random.below(mesh.slots().vertices));
        if (mesh.isVertex(v))
            return v;
    }
}

/// Makes a random change that may be sound or not: a dent, a fold, a layer pushed through another, a flattened patch,
/// unchecked edits.
void changeAtRandom(StrokeFuzzer& random, Mesh& mesh)
{
    const Lattice& lattice = mesh.lattice();
    const Slot start = randomVertex(random, mesh);
    const Vec3 center = mesh.point(start).cast<double>();
    const double edge = (mesh.point(mesh.to(mesh.outgoing(start))).cast<double>() - center).norm();
    const double radius = edge * random.uniform(0.5, 4);
    const Vec3 by = edge * random.uniform(0, 1) * random.uniform(0, 3) * random.direction();
    const std::uint64_t kind = random.below(7);
    if (kind == 0) { // a fold, or a move by a few lattice units
        const Vec3 step = random.below(2) == 0
                              ? by
                              : Vec3(lattice.unit() * static_cast<double>(random.below(4)) * random.direction());
        mesh.setPoint(start, clamped(lattice, center + step));
        return;
    }
    if (kind == 1) { // topological edits
        for (std::uint64_t i = 1 + random.below(6); i > 0; --i) {
            const Slot h = mesh.outgoing(randomVertex(random, mesh));
            const Vec3 middle = 0.5 * (mesh.point(mesh.to(h)) + mesh.point(mesh.from(h))).cast<double>();
            const Vec3f p = clamped(lattice, middle + 0.1 * random.uniform() * by);
            const std::uint64_t edit = random.below(3);
            if (edit == 0)
                mesh.splitEdge(h / 2, p);
            else if (edit == 1 && mesh.isCollapseOk(h))
                mesh.collapse(h, p);
            else if (edit == 2 && mesh.isFlipOk(h / 2))
                mesh.flip(h / 2);
        }
        return;
    }
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        const Vec3 p = mesh.isVertex(v) ? mesh.point(v).cast<double>() : Vec3(1e9, 0, 0);
        const double share = 1 - (p - center).norm() / radius;
        if (share <= 0)
            continue;
        if (kind == 2) // flattened
            mesh.setPoint(v, clamped(lattice, {p.x(), center.y(), p.z()}));
        else if (kind == 3) // moved rigidly
            mesh.setPoint(v, clamped(lattice, p + by));
        else if (kind == 4) // each vertex displaced independently
            mesh.setPoint(v, clamped(lattice, p + 0.3 * edge * random.uniform() * random.direction()));
        else // a dent or a bump
            mesh.setPoint(v, clamped(lattice, p + share * by));
    }
}

std::vector<Slot> collinearFaces(const Mesh& mesh)
{
    std::vector<Slot> faces;
    for (Slot f = 0; f < mesh.slots().faces; ++f) {
        const core::Triangle& t = mesh.corners(f);
        if (mesh.isFace(f) &&
            LatticePredicates::collinear(mesh.latticePoint(t[0]), mesh.latticePoint(t[1]), mesh.latticePoint(t[2])))
            faces.push_back(f);
    }
    return faces;
}

bool meet(const PatchFace& s, const PatchFace& t)
{
    return core::trianglesIntersect<LatticePredicates>({s.corners, s.points}, {t.corners, t.points});
}

/// Returns whether no face is degenerate and no two faces meet, which a certificate must guarantee.
bool isEmbedded(const std::vector<PatchFace>& faces)
{
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (LatticePredicates::collinear(faces[i].points[0], faces[i].points[1], faces[i].points[2]))
            return false;
        for (std::size_t j = 0; j < i; ++j) {
            if (meet(faces[i], faces[j]))
                return false;
        }
    }
    return true;
}

/// Returns a surface of 5 x 5 vertices near the plane z = 0, each displaced by up to `noise` lattice units.
std::vector<PatchFace> noisySheet(StrokeFuzzer& random, int step, int noise)
{
    constexpr int side = 5;
    std::array<LatticePoint, side * side> points;
    const auto offset = [&] {
        return static_cast<int>(random.below(static_cast<std::uint64_t>(2 * noise + 1))) - noise;
    };
    for (int i = 0; i < side * side; ++i)
        points[static_cast<std::size_t>(i)] = {i % side * step + offset(), i / side * step + offset(), offset()};
    std::vector<PatchFace> faces;
    const auto add = [&](int a, int b, int c) {
        const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
        faces.push_back({{static_cast<Slot>(a), static_cast<Slot>(b), static_cast<Slot>(c)}, {at(a), at(b), at(c)}});
    };
    for (int y = 0; y + 1 < side; ++y) {
        for (int x = 0; x + 1 < side; ++x) {
            const int a = y * side + x;
            add(a, a + 1, a + side + 1);
            add(a, a + side + 1, a + side);
        }
    }
    return faces;
}

/// Returns a random connected subset of the faces.
std::vector<PatchFace> partOf(const std::vector<PatchFace>& sheet, StrokeFuzzer& random, std::size_t size)
{
    std::vector<PatchFace> part = {sheet[random.below(sheet.size())]};
    for (int tries = 0; part.size() < size && tries < 200; ++tries) {
        const PatchFace& next = sheet[random.below(sheet.size())];
        bool known = false, neighbour = false;
        for (const PatchFace& f : part) {
            const auto shared =
                std::ranges::count_if(f.corners, [&](Slot v) { return std::ranges::count(next.corners, v) > 0; });
            known = known || shared == 3;
            neighbour = neighbour || shared == 2;
        }
        if (neighbour && !known)
            part.push_back(next);
    }
    return part;
}

std::vector<core::BoundaryEdge> boundaryOf(const std::vector<PatchFace>& faces)
{
    std::vector<core::BoundaryEdge> boundary;
    const auto hasEdge = [&](Slot from, Slot to) {
        return std::ranges::any_of(faces, [&](const PatchFace& f) {
            for (std::size_t i = 0; i < 3; ++i) {
                if (f.corners[i] == from && f.corners[(i + 1) % 3] == to)
                    return true;
            }
            return false;
        });
    };
    for (const PatchFace& f : faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            if (!hasEdge(f.corners[j], f.corners[i]))
                boundary.push_back({f.corners[i], f.corners[j], f.points[i], f.points[j]});
        }
    }
    return boundary;
}

TriangleMesh ballAndSpeck(const Vec3f& speckAt, float speckRadius, bool inwards)
{
    TriangleMesh speck = shapes::moved(core::icosphere(0, static_cast<double>(speckRadius)), speckAt);
    return shapes::together(core::icosphere(3, 1), inwards ? shapes::reversed(speck) : speck);
}

/// Moves vertices of the ball, but not of the speck, within `reach` of the pole (0, 1, 0): by `by` at the pole, less
/// around it.
void moveCap(Mesh& mesh, double reach, double by)
{
    for (Slot v = 0; v < core::icosphere(3, 1).points.size(); ++v) {
        const Vec3 p = mesh.point(v).cast<double>();
        const double x = (p - Vec3(0, 1, 0)).norm() / reach;
        if (x < 1)
            mesh.setPoint(v, mesh.lattice().snap(p + Vec3(0, by * (1 - x * x), 0)));
    }
}
} // namespace

class TestVerifier : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void randomChanges_agreeWithAllPairsAndCgal_data();
    void randomChanges_agreeWithAllPairsAndCgal();
    void recheck_findsWhatIsBadThere();
    void certifiedPatch_neverMeetsItself_data();
    void certifiedPatch_neverMeetsItself();
    void certifiedStar_neverMeetsItself();
    void nothingTouched_isSound();
    void invertedTetrahedron_isBad();
    void shellSwallowedWhole_isBad();
    void shellSweptOverFromBelow_isBad();
    void cavityLetOut_isBad();
    void cavityLetOutBehindThePush_isBad();
    void cavityLetOutOfASpike_isBad();
    void nestedShellTurnedOver_isBad();
    void changesApart_areCertifiedApart();
    void brokenLink_isBad();
};

void TestVerifier::randomChanges_agreeWithAllPairsAndCgal_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::addColumn<int>("exponent");
    QTest::newRow("sphere") << core::icosphere(2, 1) << 20;
    QTest::newRow("sphereOnACoarseLattice") << core::icosphere(1, 1) << 5;
    QTest::newRow("sphereOnTheCoarsestLattice") << core::icosphere(1, 1) << 3;
    QTest::newRow("torus") << shapes::torus({3, 1, 12, 6}) << 18;
    QTest::newRow("thinSlab") << clay::slab(2, 0.1, 4) << 20;
    QTest::newRow("thinSlabOnACoarseLattice") << clay::slab(2, 0.125, 4) << 4;
    QTest::newRow("nestedShells") << shapes::nestedSpheres(true) << 18;
    QTest::newRow("twoFingers") << shapes::together(shapes::moved(core::icosphere(1, 1), {-1.02f, 0, 0}),
                                                    shapes::moved(core::icosphere(1, 1), {1.02f, 0, 0}))
                                << 20;
}

void TestVerifier::randomChanges_agreeWithAllPairsAndCgal()
{
    QFETCH(TriangleMesh, shape);
    QFETCH(int, exponent);
    std::array<int, 3> sound{};
    int meeting = 0, degenerate = 0, nested = 0;
    StrokeFuzzer random(seed);
    std::unique_ptr<Subject> subject;
    for (int round = 0; round < 1500; ++round) {
        if (round % 250 == 0) {
            subject = std::make_unique<Subject>(sculptable(shape, Lattice(exponent)));
            VERIFY_VALID(*subject->mesh);
        }
        Mesh& mesh = *subject->mesh;
        const std::uint64_t before = mesh.stateHash();
        const Mesh::Mark mark = mesh.mark();
        changeAtRandom(random, mesh);
        const VerifyResult result = subject->verify(mark);
        const std::string where = "seed " + std::to_string(seed) + ", round " + std::to_string(round);

        const std::vector<Slot> collinear = collinearFaces(mesh), bad = mesh_asserts::badFaces(mesh);
        const std::string verdict = mesh_asserts::unsoundness(mesh);
        QVERIFY2(result.ok() == verdict.empty(), (where + ": CGAL says '" + verdict + "'").c_str());
        if (!collinear.empty()) {
            QVERIFY2(result.badFaces == collinear, where.c_str());
            ++degenerate;
        } else if (!bad.empty()) {
            QVERIFY2(result.badFaces == bad, where.c_str());
            ++meeting;
        } else if (!result.ok()) {
            ++nested;
        } else {
            ++sound[static_cast<std::size_t>(result.tier)];
        }
        if (result.ok() && random.below(4) == 0) {
            subject->index(mark);
            mesh.commit(mark);
            QVERIFY(subject->octree.isConsistent(mesh));
        } else {
            mesh.rollback(mark);
            QCOMPARE(mesh.stateHash(), before);
        }
    }
    std::cout << QTest::currentDataTag() << ": sound by patch, stars, pairs " << sound[0] << ' ' << sound[1] << ' '
              << sound[2] << ", meeting " << meeting << ", degenerate " << degenerate << ", turned or swallowed "
              << nested << std::endl;
    QVERIFY(sound[0] + sound[1] + sound[2] > 100 && meeting > 100);
}

/// After an unsound motion, some vertices go back part of the way. The short check of these vertices must find the same
/// bad faces as the full check.
void TestVerifier::recheck_findsWhatIsBadThere()
{
    StrokeFuzzer random(seed);
    int looked = 0, found = 0;
    while (looked < 300) {
        Subject subject(sculptable(core::icosphere(3, 1)));
        Mesh& mesh = *subject.mesh;
        const Mesh::Mark mark = mesh.mark();
        std::vector<std::pair<Slot, Vec3f>> moved;
        const Vec3 center = mesh.point(randomVertex(random, mesh)).cast<double>(),
                   by = random.uniform(0, 1.2) * random.direction();
        for (Slot v = 0; v < mesh.slots().vertices; ++v) {
            const Vec3 p = mesh.point(v).cast<double>();
            if ((p - center).norm() > 0.5)
                continue;
            moved.emplace_back(v, mesh.point(v));
            mesh.setPoint(v, clamped(mesh.lattice(), p + random.uniform() * by));
        }
        if (subject.verify(mark).ok())
            continue;
        std::vector<Slot> back;
        for (const auto& [v, before] : moved) {
            if (random.below(4) != 0)
                continue;
            back.push_back(v);
            mesh.setPoint(v, mesh.lattice().snap(0.5 * (before + mesh.point(v)).cast<double>()));
        }
        if (!collinearFaces(mesh).empty())
            continue;
        const std::vector<Slot> there = subject.verifier.recheck(mesh, back);
        const std::vector<Slot> all = Verifier().verify(mesh, subject.octree, mesh.touchedSince(mark)).badFaces;
        QVERIFY(std::ranges::includes(all, there));
        for (Slot v : back) {
            mesh.forEachOutgoing(v, [&](Slot h) {
                QCOMPARE(std::ranges::binary_search(there, mesh.face(h)),
                         std::ranges::binary_search(all, mesh.face(h)));
            });
        }
        ++looked;
        found += !there.empty();
    }
    QVERIFY2(found > 50 && found < 300, qPrintable(QString::number(found)));
}

void TestVerifier::certifiedPatch_neverMeetsItself_data()
{
    QTest::addColumn<int>("step");
    QTest::addColumn<int>("noise");
    QTest::newRow("tinyIntegers") << 1 << 1;
    QTest::newRow("smallIntegers") << 3 << 2;
    QTest::newRow("rough") << 100 << 80;
    QTest::newRow("largest") << 1'600'000 << 900'000;
}

void TestVerifier::certifiedPatch_neverMeetsItself()
{
    QFETCH(int, step);
    QFETCH(int, noise);
    StrokeFuzzer random(seed);
    int certified = 0, embedded = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::vector<PatchFace> faces = partOf(noisySheet(random, step, noise), random, 1 + random.below(10));
        std::vector<core::BoundaryEdge> boundary = boundaryOf(faces);
        Vec3 direction(0, 0, 1);
        if (random.below(2) == 0) {
            direction = Vec3::Zero();
            for (const PatchFace& f : faces)
                direction +=
                    (f.points[1] - f.points[0]).cast<double>().cross((f.points[2] - f.points[0]).cast<double>());
        }
        const bool sound = isEmbedded(faces);
        const bool proved = core::certifyPatch(faces, boundary, core::integerDirection(direction));
        QVERIFY2(sound || !proved, qPrintable(QString::fromLatin1("seed %1, patch %2").arg(seed).arg(i)));
        embedded += sound;
        certified += proved;
    }
    std::cout << QTest::currentDataTag() << ": " << certified << " patches certified of " << embedded << " embedded"
              << std::endl;
    QVERIFY(certified > 1000);
}

void TestVerifier::certifiedStar_neverMeetsItself()
{
    for (int range : {2, 4, 1000, Lattice::limit}) {
        StrokeFuzzer random(seed);
        const Lattice lattice(0);
        TriangleMesh shape = core::icosphere(1, 100);
        const auto mesh = sculptable(shape, lattice);
        mesh->beginStroke();
        int certified = 0, embedded = 0;
        const auto coordinate = [&](double around) {
            const double x = around * range + random.uniform(-1, 1) * range;
            return std::clamp(x, -double(Lattice::limit), double(Lattice::limit));
        };
        for (int i = 0; i < 75'000; ++i) {
            const Mesh::Mark mark = mesh->mark();
            const Slot v = static_cast<Slot>(random.below(mesh->slots().vertices));
            mesh->setPoint(v, Vec3f::Zero());
            mesh->forEachOutgoing(v, [&](Slot h) { // places the neighbours around the vertex, approximately in a plane
                const Vec3 p = mesh->point(mesh->to(h)).cast<double>();
                const Vec3 flat = random.below(3) == 0 ? Vec3::Zero() : Vec3(p.normalized());
                mesh->setPoint(mesh->to(h),
                               lattice.snap({coordinate(flat.x()), coordinate(flat.y()), coordinate(flat.z())}));
            });
            std::vector<PatchFace> star;
            mesh->forEachOutgoing(v, [&](Slot h) {
                const core::Triangle& t = mesh->corners(mesh->face(h));
                star.push_back({t, {mesh->latticePoint(t[0]), mesh->latticePoint(t[1]), mesh->latticePoint(t[2])}});
            });
            const bool sound = isEmbedded(star), proved = core::certifyStar(*mesh, v);
            QVERIFY2(sound || !proved,
                     qPrintable(QString::fromLatin1("seed %1, range %2, star %3").arg(seed).arg(range).arg(i)));
            embedded += sound;
            certified += proved;
            mesh->rollback(mark);
        }
        std::cout << "range " << range << ": " << certified << " stars certified of " << embedded << " embedded"
                  << std::endl;
        QVERIFY(certified > 100);
    }
}

void TestVerifier::nothingTouched_isSound()
{
    Subject subject(sculptable(core::icosphere(2, 1)));
    QVERIFY(subject.verify(subject.mesh->mark()).ok());
    QVERIFY(subject.verifier.dirtyFaces().empty());
}

void TestVerifier::invertedTetrahedron_isBad()
{
    Subject subject(sculptable(shapes::tetrahedron()));
    const Mesh::Mark mark = subject.mesh->mark();
    subject.mesh->setPoint(0, {-1, -1, -1}); // moves the vertex through the plane of the other three
    QCOMPARE(subject.verify(mark).badFaces, (std::vector<Slot>{0, 1, 2, 3}));
}

void TestVerifier::shellSwallowedWhole_isBad()
{
    Subject subject(sculptable(ballAndSpeck({0, 1.1f, 0}, 0.03f, false)));
    VERIFY_VALID(*subject.mesh);
    const Mesh::Mark mark = subject.mesh->mark();
    moveCap(*subject.mesh, 0.8, 0.4);
    QVERIFY(mesh_asserts::badFaces(*subject.mesh).empty());
    QVERIFY(!mesh_asserts::unsoundness(*subject.mesh).empty());
    QVERIFY(!subject.verify(mark).ok());
}

/// The bottom of a dent rises past a speck that floats in it. The speck is then below every face that moved.
void TestVerifier::shellSweptOverFromBelow_isBad()
{
    Subject subject(sculptable(ballAndSpeck({0, 0.6f, 0}, 0.02f, true)));
    Mesh& mesh = *subject.mesh;
    Mesh::Mark mark = mesh.mark();
    moveCap(mesh, 0.8, -0.6); // makes the dent, so that the cavity becomes an inside-out speck outside the ball
    for (Slot f = 0; f < mesh.slots().faces; ++f)
        QVERIFY(mesh.isFace(f));
    mesh.commit(mark);
    // The speck now faces outwards, which makes the model sound.
    Subject dented(sculptable(shapes::together(
        [&] {
            TriangleMesh ball = mesh_asserts::surfaceOf(mesh);
            ball.colors.clear();
            ball.points.resize(core::icosphere(3, 1).points.size());
            ball.triangles.resize(core::icosphere(3, 1).triangles.size());
            return ball;
        }(),
        shapes::moved(core::icosphere(0, 0.02), {0, 0.6f, 0}))));
    VERIFY_VALID(*dented.mesh);
    mark = dented.mesh->mark();
    for (Slot v = 0; v < core::icosphere(3, 1).points.size(); ++v) {
        const Vec3 p = dented.mesh->point(v).cast<double>();
        if (Vec3(p.x(), 0, p.z()).norm() < 0.3 && p.y() > 0 && p.y() < 0.75)
            dented.mesh->setPoint(v, dented.mesh->lattice().snap(Vec3(p.x(), 0.7 + 0.1 * p.squaredNorm(), p.z())));
    }
    QVERIFY(mesh_asserts::badFaces(*dented.mesh).empty());
    QVERIFY(!mesh_asserts::unsoundness(*dented.mesh).empty());
    QVERIFY(!dented.verify(mark).ok());
}

void TestVerifier::cavityLetOut_isBad()
{
    Subject subject(sculptable(ballAndSpeck({0, 0.8f, 0}, 0.03f, true)));
    VERIFY_VALID(*subject.mesh);
    const Mesh::Mark mark = subject.mesh->mark();
    moveCap(*subject.mesh, 0.8, -0.5);
    QVERIFY(mesh_asserts::badFaces(*subject.mesh).empty());
    QVERIFY(!mesh_asserts::unsoundness(*subject.mesh).empty());
    QVERIFY(!subject.verify(mark).ok());
}

/// Variant of cavityLetOut_isBad(): the cavity is so near the pole that it is above the new position of every moved
/// face.
void TestVerifier::cavityLetOutBehindThePush_isBad()
{
    Subject subject(sculptable(ballAndSpeck({0, 0.96f, 0}, 0.01f, true)));
    VERIFY_VALID(*subject.mesh);
    const Mesh::Mark mark = subject.mesh->mark();
    moveCap(*subject.mesh, 0.8, -0.5);
    QVERIFY(mesh_asserts::badFaces(*subject.mesh).empty());
    QVERIFY(!mesh_asserts::unsoundness(*subject.mesh).empty());
    QVERIFY(!subject.verify(mark).ok());
}

/// A collapse removes a spike that contains a cavity. The cavity is far from all remaining faces.
void TestVerifier::cavityLetOutOfASpike_isBad()
{
    TriangleMesh spiked = core::icosphere(3, 1);
    const auto top = std::ranges::max_element(spiked.points, {}, [](const Vec3f& p) { return p.y(); });
    const Slot tip = static_cast<Slot>(top - spiked.points.begin());
    const Vec3f foot = *top;
    top->y() = 2.5f;
    Subject subject(sculptable(shapes::together(
        spiked, shapes::reversed(shapes::moved(core::icosphere(0, 0.01), {foot.x(), 1.7f, foot.z()})))));
    Mesh& mesh = *subject.mesh;
    VERIFY_VALID(mesh);
    const Mesh::Mark mark = mesh.mark();
    const Slot h = mesh.outgoing(tip);
    QVERIFY(mesh.isCollapseOk(h));
    mesh.collapse(h, mesh.point(mesh.to(h)));
    QVERIFY(mesh_asserts::badFaces(mesh).empty());
    QVERIFY(!mesh_asserts::unsoundness(mesh).empty());
    QVERIFY(!subject.verify(mark).ok());
}

void TestVerifier::nestedShellTurnedOver_isBad()
{
    const auto outer = static_cast<Slot>(core::icosphere(2, 3).points.size());
    Subject subject(sculptable(shapes::nestedSpheres(true)));
    const Mesh::Mark mark = subject.mesh->mark();
    for (Slot v = outer; v < subject.mesh->slots().vertices; ++v) {
        const Vec3f p = subject.mesh->point(v);
        subject.mesh->setPoint(v, {-p.x(), p.y(), p.z()});
    }
    const VerifyResult result = subject.verify(mark);
    QCOMPARE(result.badFaces.size(), core::icosphere(1, 1).triangles.size());
    QVERIFY(result.badFaces.front() >= core::icosphere(2, 3).triangles.size());
}

/// Two separate changes, as on both sides of a mirror plane, must each be proved by a certificate. The area between
/// them is not checked.
void TestVerifier::changesApart_areCertifiedApart()
{
    Subject subject(sculptable(core::icosphere(4, 1)));
    Mesh& mesh = *subject.mesh;
    const Mesh::Mark mark = mesh.mark();
    for (const double side : {-1.0, 1.0}) {
        for (Slot v = 0; v < mesh.slots().vertices; ++v) {
            const Vec3 p = mesh.point(v).cast<double>();
            if (side * p.x() > 0.95)
                mesh.setPoint(v, mesh.lattice().snap(1.02 * p));
        }
    }
    const VerifyResult result = subject.verify(mark);
    QVERIFY(result.ok());
    QVERIFY(result.tier == core::VerifyTier::Patch);
}

/// Links can only be damaged by a forged delta, because the functions of Mesh keep them consistent.
void TestVerifier::brokenLink_isBad()
{
    Subject subject(sculptable(core::icosphere(1, 1)));
    Mesh& mesh = *subject.mesh;
    Mesh::Mark mark = mesh.mark();
    mesh.flip(7);
    const core::TouchedSlots touched = mesh.touchedSince(mark);
    QVERIFY(subject.verifier.verify(mesh, subject.octree, touched).ok());
    core::MeshDelta delta = mesh.endStroke();
    mesh.swap(delta); // undone; the delta now contains the flipped state
    QVERIFY(delta.edges.size() >= 2);
    std::swap(delta.edges[0].item, delta.edges[1].item);
    mesh.swap(delta);
    QVERIFY(!mesh_asserts::brokenLinks(mesh).empty());
    QVERIFY(!subject.verifier.verify(mesh, subject.octree, touched).ok());
}

FETTLE_TEST(TestVerifier)
#include "tst_verifier.moc"
