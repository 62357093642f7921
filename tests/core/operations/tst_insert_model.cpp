#include "core/mesh/mesh_builder.h"
#include "core/operations/detached_part.h"
#include "core/operations/model_command.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

using namespace core;

namespace
{
ModelChange tried(const TriangleMesh& present, const Insert& command)
{
    return applyToCopy(*buildMesh(present).mesh, command);
}
} // namespace

class TestInsertModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void besides_standsClearOnTheSameFloor();
    void coloursComeAlong();
    void undo_restoresTheState();
    void intoAVoid_isTaken();
    void into_theMatterIsRefused();
    void around_thePresentModelIsRefused();
    void touching_isRefused_data();
    void touching_isRefused();
    void overlapping_isRefused();
    void unsoundModel_isRefusedWithItsReport();
    void tooFar_isRefused();
    void largeModel_makesTheLatticeCoarser();
    void tinyModel_isRefusedWithTheNumberOfItsFaces();
    void stopped_changesNothing();
    void part_mayOverlap();
    void part_getsAFreeName();
    void part_takesAllToItsLattice();
    void part_isRefusedAsOthersAre();
};

void TestInsertModel::besides_standsClearOnTheSameFloor()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    ModelChange change = applyToCopy(*mesh, Insert{shapes::moved(icosphere(2, 10), {500, 500, 500})});
    QVERIFY(change.changes);
    mesh->swap(change.delta);
    VERIFY_VALID(*mesh);
    const MeshReport report = checkMesh(extractMesh(*mesh));
    QCOMPARE(report.components, std::size_t(2));
    QVERIFY(std::abs(report.size.x() - (100 + 5 + 20)) < 0.5);
    QVERIFY(report.size.y() < 100.1);
}

void TestInsertModel::coloursComeAlong()
{
    const auto mesh = buildMesh(icosphere(2, 50)).mesh;
    TriangleMesh red = icosphere(1, 10);
    red.colors.assign(red.points.size(), {255, 0, 0});
    ModelChange change = applyToCopy(*mesh, Insert{red});
    mesh->swap(change.delta);
    const TriangleMesh both = extractMesh(*mesh);
    QCOMPARE(std::size_t(std::ranges::count(both.colors, Rgb{255, 0, 0})), red.points.size());
    QCOMPARE(std::size_t(std::ranges::count(both.colors, Rgb())), both.points.size() - red.points.size());
}

void TestInsertModel::undo_restoresTheState()
{
    const auto mesh = buildMesh(clay::bowl()).mesh;
    const std::uint64_t before = mesh->stateHash();
    ModelChange change = applyToCopy(*mesh, Insert{clay::twoFingers(0.1)});
    mesh->swap(change.delta);
    const std::uint64_t after = mesh->stateHash();
    VERIFY_VALID(*mesh);
    mesh->swap(change.delta);
    QCOMPARE(mesh->stateHash(), before);
    mesh->swap(change.delta);
    QCOMPARE(mesh->stateHash(), after);
}

void TestInsertModel::intoAVoid_isTaken()
{
    const auto mesh = buildMesh(shapes::nestedSpheres(true)).mesh;
    ModelChange change = applyToCopy(*mesh, Insert{shapes::scaled(icosphere(2, 1), 0.1f), Insert::Place::Centre});
    QVERIFY(change.refusal == ModelRefusal::None && change.changes);
    mesh->swap(change.delta);
    VERIFY_VALID(*mesh);
}

void TestInsertModel::into_theMatterIsRefused()
{
    QVERIFY(tried(icosphere(3, 50), {icosphere(2, 10), Insert::Place::AsItIs}).refusal == ModelRefusal::Inside);
    QVERIFY(tried(icosphere(3, 50), {icosphere(2, 10), Insert::Place::Centre, {20, 0, 0}}).refusal ==
            ModelRefusal::Inside);
}

void TestInsertModel::around_thePresentModelIsRefused()
{
    QVERIFY(tried(icosphere(2, 10), {icosphere(3, 50), Insert::Place::AsItIs}).refusal == ModelRefusal::Inside);
}

void TestInsertModel::touching_isRefused_data()
{
    QTest::addColumn<Vec3f>("at");
    QTest::newRow("face on face") << Vec3f(20, 0, 0);
    QTest::newRow("half a face on a face") << Vec3f(20, 10, 5);
    QTest::newRow("edge on edge") << Vec3f(20, 20, 3);
    QTest::newRow("corner on corner") << Vec3f(20, 20, 20);
}

void TestInsertModel::touching_isRefused()
{
    QFETCH(Vec3f, at);
    const TriangleMesh cube = shapes::cube(20);
    const ModelChange change = tried(cube, {shapes::moved(cube, at), Insert::Place::AsItIs});
    QVERIFY(change.refusal == ModelRefusal::Touching && !change.changes && change.delta.empty());
    QVERIFY(tried(cube, {shapes::moved(cube, 1.001f * at), Insert::Place::AsItIs}).changes);
}

void TestInsertModel::overlapping_isRefused()
{
    QVERIFY(tried(icosphere(3, 50), {icosphere(2, 20), Insert::Place::Centre, {50, 0, 0}}).refusal ==
            ModelRefusal::Touching);
}

void TestInsertModel::unsoundModel_isRefusedWithItsReport()
{
    const ModelChange change = tried(icosphere(3, 50), {shapes::openCone(12)});
    QVERIFY(change.refusal == ModelRefusal::Unsound);
    QVERIFY(change.report.openEdges.count > 0);
    QVERIFY(tried(icosphere(3, 50), {shapes::reversed(icosphere(2, 10))}).refusal == ModelRefusal::Unsound);
    QVERIFY(tried(icosphere(3, 50), {TriangleMesh()}).refusal == ModelRefusal::Unsound);
}

void TestInsertModel::tooFar_isRefused()
{
    QVERIFY(tried(icosphere(3, 50), {icosphere(2, 10), Insert::Place::Centre, {0, 450, 0}}).refusal ==
            ModelRefusal::TooFar);
    QVERIFY(tried(icosphere(3, 50), {icosphere(2, 10), Insert::Place::Centre, {0, 350, 0}}).changes);
}

void TestInsertModel::largeModel_makesTheLatticeCoarser()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    const Lattice before = mesh->lattice();
    ModelChange change = applyToCopy(*mesh, Insert{icosphere(3, 5000)});
    QVERIFY(change.changes);
    mesh->swap(change.delta);
    QVERIFY(mesh->lattice().exponent() < before.exponent());
    VERIFY_VALID(*mesh);
    mesh->swap(change.delta);
    QVERIFY(mesh->lattice() == before);
}

void TestInsertModel::tinyModel_isRefusedWithTheNumberOfItsFaces()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    const ModelChange change = applyToCopy(*mesh, Insert{icosphere(1, mesh->lattice().unit() / 4)});
    QVERIFY(change.refusal == ModelRefusal::FacesMeet);
    QVERIFY(change.faces > 0);
}

void TestInsertModel::stopped_changesNothing()
{
    for (int stopAt = 1; stopAt <= 3; ++stopAt) {
        std::stop_source source;
        int calls = 0;
        const JobControl control{source.get_token(), [&](double) {
                                     if (++calls == stopAt)
                                         source.request_stop();
                                 }};
        const auto mesh = buildMesh(icosphere(3, 50)).mesh;
        const ModelChange change = applyToCopy(*mesh, Insert{icosphere(3, 20)}, control);
        QVERIFY(!change.changes && change.delta.empty());
    }
}

namespace
{
Insert asPart(const TriangleMesh& model, const std::string& name, const Vec3& centre = Vec3::Zero())
{
    Insert insert{model, Insert::Place::Centre, centre, Insert::Combination::Part};
    insert.name = name;
    return insert;
}

void insert(Mesh& mesh, const Insert& command)
{
    ModelChange change = applyToCopy(mesh, command);
    mesh.swap(change.delta);
}

double volumeOf(const Mesh& mesh, PartId part)
{
    return checkMesh(surfaceOf(mesh, part)).volume.value_or(0);
}
} // namespace

void TestInsertModel::part_mayOverlap()
{
    const TriangleMesh small = icosphere(2, 10);
    for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(50, 0, 0), Vec3(60, 0, 0), Vec3(100, 0, 0)}) {
        const auto mesh = buildMesh(icosphere(3, 50)).mesh;
        const double before = volumeOf(*mesh, 0);
        const std::uint64_t start = mesh->stateHash();
        ModelChange change = applyToCopy(*mesh, asPart(small, "Nose", centre), {}, PartId(0));
        QVERIFY(change.refusal == ModelRefusal::None && change.changes);
        QCOMPARE(change.addedPart.value_or(0), PartId(1));
        mesh->swap(change.delta);
        QCOMPARE(mesh->frame().parts.size(), std::size_t(2));
        QCOMPARE(mesh->frame().parts.all().back().name, std::string("Nose"));
        QCOMPARE(volumeOf(*mesh, 0), before);
        QVERIFY(std::abs(volumeOf(*mesh, 1) / checkMesh(small).volume.value() - 1) < 1e-4);
        QVERIFY(checkMesh(extractMesh(*mesh)).printReady());
        const std::uint64_t after = mesh->stateHash();
        mesh->swap(change.delta);
        QCOMPARE(mesh->stateHash(), start);
        mesh->swap(change.delta);
        QCOMPARE(mesh->stateHash(), after);
    }
}

void TestInsertModel::part_getsAFreeName()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    const std::string longName(PartList::maxNameBytes, 'x');
    for (const std::string& name : {std::string("Ball"), std::string("Ball"), std::string(), std::string("Ball"),
                                    std::string(), longName, longName})
        insert(*mesh, asPart(icosphere(1, 10), name));
    std::vector<std::string> names;
    for (const Part& part : mesh->frame().parts.all())
        names.push_back(part.name);
    std::string numbered(PartList::maxNameBytes - 5, 'x'); // GCC 12 warns of a sum (GCC bug 105329)
    numbered += " 2";
    QVERIFY(names == std::vector<std::string>({"", "Ball", "Ball 2", "", "Ball 3", "", longName, numbered}));
}

void TestInsertModel::part_takesAllToItsLattice()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    insert(*mesh, asPart(icosphere(2, 20), "Ball", {30, 0, 0}));
    const Lattice lattice = mesh->lattice();
    const std::uint64_t before = mesh->stateHash();
    ModelChange change = applyToCopy(*mesh, asPart(icosphere(3, 5000), "World"), {}, PartId(1));
    QVERIFY(change.changes);
    mesh->swap(change.delta);
    QVERIFY(mesh->lattice().exponent() < lattice.exponent());
    QCOMPARE(mesh->frame().parts.size(), std::size_t(3));
    QVERIFY(checkMesh(extractMesh(*mesh)).printReady());
    mesh->swap(change.delta);
    QCOMPARE(mesh->stateHash(), before);
}

void TestInsertModel::part_isRefusedAsOthersAre()
{
    const TriangleMesh present = icosphere(3, 50);
    QVERIFY(tried(present, asPart(shapes::openCone(12), "a")).refusal == ModelRefusal::Unsound);
    QVERIFY(tried(present, asPart(TriangleMesh(), "a")).refusal == ModelRefusal::Unsound);
    QVERIFY(tried(present, asPart(icosphere(2, 10), "a", {0, 450, 0})).refusal == ModelRefusal::TooFar);
    const double unit = buildMesh(present).mesh->lattice().unit();
    QVERIFY(tried(present, asPart(icosphere(1, unit / 4), "a")).refusal == ModelRefusal::FacesMeet);
    Insert impossible = asPart({}, "a");
    impossible.primitive.emplace().kind = Primitive::Kind::Ball;
    impossible.primitive->length(Primitive::Measure::Radius) = 0;
    QVERIFY(tried(present, impossible).refusal == ModelRefusal::Primitive);

    std::vector<Part> parts(PartList::maxParts);
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i].id = static_cast<PartId>(i);
    MeshFrame full;
    full.parts = PartList(parts);
    const auto mesh = buildMesh(present).mesh;
    mesh->beginStroke();
    full.lattice = mesh->lattice();
    mesh->setFrame(full);
    mesh->endStroke();
    QVERIFY(applyToCopy(*mesh, asPart(icosphere(1, 10), "a")).refusal == ModelRefusal::TooManyParts);
}

FETTLE_TEST(TestInsertModel)
#include "tst_insert_model.moc"
