// Inserts primitives together with their mirror images.

#include "core/mesh/mesh_builder.h"
#include "core/operations/detached_part.h"
#include "core/operations/mirror_image.h"
#include "core/operations/model_command.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/environment.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

using namespace core;
using Kind = Primitive::Kind;
using Measure = Primitive::Measure;

namespace
{
/// Returns a model about 3 wide that is symmetric about the plane.
std::unique_ptr<Mesh> symmetricModel(Symmetry plane, bool isBall)
{
    auto mesh = buildMesh(isBall ? icosphere(3, 1) : clay::bowl()).mesh;
    ModelChange change = applyToCopy(*mesh, Symmetrize{plane, Half::Positive});
    mesh->swap(change.delta);
    return mesh;
}

/// Returns a solid of coarse edges, about as large as the size says, with a random axis.
Primitive randomSolid(StrokeFuzzer& random, double size)
{
    constexpr Kind kinds[] = {Kind::Cuboid, Kind::Ball, Kind::Cylinder, Kind::Cone, Kind::Capsule, Kind::Torus};
    Primitive solid;
    solid.kind = kinds[random.below(std::size(kinds))];
    for (const Measure measure : measuresOf(solid.kind))
        solid.length(measure) = size * random.uniform(0.5, 1);
    solid.length(Measure::TubeRadius) = 0.4 * solid.length(Measure::Radius);
    if (solid.kind == Kind::Capsule)
        solid.length(Measure::Height) = 3 * solid.length(Measure::Radius);
    solid.axis = random.direction();
    solid.edge = 1e6 * size; // too long: the longest that is possible is used
    solid.edge = judgePrimitive(solid).limit;
    return solid;
}

double volumeInside(const Mesh& mesh)
{
    return *checkMesh(extractMesh(mesh)).volume;
}

/// Returns the model changed by the command; nothing if it was refused.
std::unique_ptr<Mesh> made(const Mesh& mesh, const ModelCommand& command)
{
    ModelChange change = applyToCopy(mesh, command);
    if (change.refusal != ModelRefusal::None)
        return nullptr;
    auto after = std::make_unique<Mesh>(mesh);
    after->swap(change.delta);
    return after;
}
} // namespace

class TestMirroredInsertion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void model_remainsSymmetric_data();
    void model_remainsSymmetric();
    void both_areCombined();
    void part_isSymmetric();
    void tubeInThePlane_staysOne();
    void solidPutOnThePlane_isItsOwnImage();
    void solidInThePlane_staysAsItIs();
    void attributes_stayOnTheirSide();
    void undo_restoresTheState();
};

void TestMirroredInsertion::model_remainsSymmetric_data()
{
    QTest::addColumn<Symmetry>("plane");
    QTest::addRow("x") << Symmetry::X;
    QTest::addRow("y") << Symmetry::Y;
    QTest::addRow("z") << Symmetry::Z;
}

void TestMirroredInsertion::model_remainsSymmetric()
{
    QFETCH(const Symmetry, plane);
    const std::uint64_t seed = numberFromEnvironment("FETTLE_SEED", 7);
    StrokeFuzzer random(seed);
    int done = 0;
    const int rounds = byEffort(20, 150);
    for (int i = 0; i < rounds; ++i) {
        const auto mesh = symmetricModel(plane, i % 2 == 0);
        Insert insert{{}, Insert::Place::Centre, random.uniform(0.3, 1.2) * random.direction()};
        insert.primitive = randomSolid(random, random.uniform(0.1, 0.6));
        insert.combination =
            Insert::Combination(std::size_t(Insert::Combination::Join) + random.below(2)); // join or subtract
        insert.symmetry = plane;
        const auto after = made(*mesh, insert);
        if (!after)
            continue;
        ++done;
        const std::string where = "seed " + std::to_string(seed) + ", round " + std::to_string(i);
        const std::string asymmetry = mirror_asserts::asymmetry(*after, plane);
        QVERIFY2(asymmetry.empty(), (where + ": " + asymmetry).c_str());
        VERIFY_VALID(*after);
    }
    QVERIFY2(done >= rounds * 9 / 10, qPrintable(QString::number(done)));
}

/// The result is what two insertions make, one at either side.
void TestMirroredInsertion::both_areCombined()
{
    StrokeFuzzer random(11);
    const auto mesh = symmetricModel(Symmetry::X, true);
    for (int i = 0; i < 10; ++i) {
        Insert insert{{}, Insert::Place::Centre, random.uniform(0.5, 1) * random.direction()};
        insert.primitive = randomSolid(random, 0.5);
        insert.combination = i % 2 ? Insert::Combination::Join : Insert::Combination::Subtract;
        Insert image = insert, both = insert;
        image.centre.x() *= -1;
        image.primitive->axis.x() *= -1;
        if (insert.primitive->kind == Kind::Cuboid)
            continue; // its image is turned otherwise about the axis
        both.symmetry = Symmetry::X;
        const auto one = made(*mesh, insert);
        const auto two = one ? made(*one, image) : nullptr;
        const auto mirrored = made(*mesh, both);
        QVERIFY(two && mirrored);
        QVERIFY(std::abs(volumeInside(*two) - volumeInside(*mirrored)) < 2e-3 * volumeInside(*mesh));
    }
}

/// A solid beside the plane and its image are one part of two pieces; one that crosses the plane is one piece.
void TestMirroredInsertion::part_isSymmetric()
{
    const auto mesh = symmetricModel(Symmetry::X, true);
    for (const double x : {0.8, 0.1}) {
        Insert insert{{}, Insert::Place::Centre, {x, 0.5, 0.2}, Insert::Combination::Part};
        insert.primitive.emplace().kind = Kind::Cylinder;
        insert.primitive->length(Measure::Radius) = 0.2;
        insert.primitive->length(Measure::Height) = 0.5;
        insert.primitive->axis = {0.2, 1, 0.3};
        insert.symmetry = Symmetry::X;
        const auto after = made(*mesh, insert);
        QVERIFY(after);
        const TriangleMesh part = surfaceOf(*after, after->frame().parts.all().back().id);
        const MeshReport report = checkMesh(part);
        QVERIFY(report.printReady());
        QCOMPARE(report.components, std::size_t(x > 0.5 ? 2 : 1));
        VERIFY_SYMMETRIC(Mesh(part, after->lattice()), Symmetry::X);
    }
}

/// A tube whose path is in the plane is its own image but for its triangles: it gets no slivers.
void TestMirroredInsertion::tubeInThePlane_staysOne()
{
    const auto mesh = symmetricModel(Symmetry::X, true);
    Insert insert{{}, Insert::Place::AsItIs, {}, Insert::Combination::Part};
    insert.primitive.emplace().kind = Kind::Tube;
    insert.primitive->path = {{{0, 1, 0}, 0.1}, {{0, 1.3, 0.4}, 0.15}, {{0, 1, 1}, 0.1}, {{0, 0.2, 1.1}, 0.2}};
    const TriangleMesh plain = surfaceOf(*made(*mesh, insert), 1);
    insert.symmetry = Symmetry::X;
    const auto after = made(*mesh, insert);
    QVERIFY(after);
    const TriangleMesh part = surfaceOf(*after, 1);
    VERIFY_SYMMETRIC(Mesh(part, after->lattice()), Symmetry::X);
    QVERIFY(checkMesh(part).printReady());
    QCOMPARE_LE(part.triangles.size(), plain.triangles.size());
}

/// A solid that putOnPlane() puts on any plane is its own image: it stays one solid of its volume.
void TestMirroredInsertion::solidPutOnThePlane_isItsOwnImage()
{
    StrokeFuzzer random(31);
    const auto mesh = symmetricModel(Symmetry::X, true);
    for (int i = 0; i < 90; ++i) {
        const auto plane = Symmetry(std::size_t(Symmetry::X) + std::size_t(i) % 3);
        Insert insert{{}, Insert::Place::Centre, Vec3(0.5, 0.6, 0.7), Insert::Combination::Part};
        insert.primitive = randomSolid(random, 0.4);
        insert.primitive->axis = random.direction();
        if (i % 10 == 0) // almost at a right angle
            insert.primitive->axis = planeNormal(plane) + 0.04 * insert.primitive->axis;
        if (insert.primitive->kind == Kind::Cone && i % 10 == 0)
            continue; // its ends differ
        putOnPlane(insert.centre, insert.primitive->axis, plane);
        insert.symmetry = plane;
        const auto after = made(*mesh, insert);
        const std::string where = "round " + std::to_string(i);
        QVERIFY2(after, where.c_str());
        const TriangleMesh part = surfaceOf(*after, 1), plain = *makePrimitive(*insert.primitive).mesh;
        QVERIFY2(mirror_asserts::asymmetry(Mesh(part, after->lattice()), plane).empty(), where.c_str());
        QVERIFY2(part.triangles.size() == plain.triangles.size(), where.c_str());
        QVERIFY2(std::abs(*checkMesh(part).volume / *checkMesh(plain).volume - 1) < 1e-3, where.c_str());
    }
}

void TestMirroredInsertion::solidInThePlane_staysAsItIs()
{
    const auto mesh = symmetricModel(Symmetry::X, true);
    Insert insert{{}, Insert::Place::Centre, {0, 0.9, 0.3}, Insert::Combination::Join};
    insert.primitive.emplace().kind = Kind::Cone;
    insert.primitive->length(Measure::Radius) = 0.3;
    insert.primitive->length(Measure::Height) = 0.6;
    insert.primitive->axis = {0, 1, 0.4};
    const auto plain = made(*mesh, insert);
    insert.symmetry = Symmetry::X;
    const auto mirrored = made(*mesh, insert);
    QVERIFY(plain && mirrored);
    VERIFY_SYMMETRIC(*mirrored, Symmetry::X);
    QVERIFY(std::abs(volumeInside(*plain) - volumeInside(*mirrored)) < 1e-4 * volumeInside(*plain));
}

/// Paint and mask that only one side has stay on that side.
void TestMirroredInsertion::attributes_stayOnTheirSide()
{
    StrokeFuzzer random(23);
    for (int i = 0; i < 6; ++i) {
        const auto mesh = symmetricModel(Symmetry::X, true);
        mesh->beginStroke();
        for (const Slot v : mesh->vertices()) {
            if (mesh->point(v).x() > 0 && mesh->point(v).y() < 0) {
                mesh->setColor(v, {200, 10, 10});
                mesh->setMask(v, 90);
            }
        }
        mesh->endStroke();
        Insert insert{{}, Insert::Place::Centre, Vec3(random.uniform(0.2, 0.6), 0.7, random.uniform(0, 0.5))};
        insert.primitive = randomSolid(random, 0.3);
        insert.combination = i % 2 ? Insert::Combination::Join : Insert::Combination::Subtract;
        insert.symmetry = Symmetry::X;
        const auto after = made(*mesh, insert);
        QVERIFY(after);
        for (const Slot v : after->vertices()) {
            if (after->point(v).x() < 0)
                QVERIFY(after->color(v) == Rgb() && after->mask(v) == 0);
            else if (after->point(v).y() < -0.2 && after->point(v).x() > 0)
                QVERIFY(after->color(v) == (Rgb{200, 10, 10}) && after->mask(v) == 90);
        }
    }
}

void TestMirroredInsertion::undo_restoresTheState()
{
    const auto mesh = symmetricModel(Symmetry::Z, false);
    const std::uint64_t before = mesh->stateHash();
    Insert insert{{}, Insert::Place::Centre, {0.2, 0, 0.9}, Insert::Combination::Join};
    insert.primitive.emplace().kind = Kind::Ball;
    insert.primitive->length(Measure::Radius) = 0.4;
    insert.symmetry = Symmetry::Z;
    ModelChange change = applyToCopy(*mesh, insert);
    QVERIFY(change.changes);
    mesh->swap(change.delta);
    QVERIFY(mesh->stateHash() != before);
    mesh->swap(change.delta);
    QCOMPARE(mesh->stateHash(), before);
}

FETTLE_TEST(TestMirroredInsertion)
#include "tst_mirrored_insertion.moc"
