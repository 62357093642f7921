#include "core/mesh/mesh_builder.h"
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

FETTLE_TEST(TestInsertModel)
#include "tst_insert_model.moc"
