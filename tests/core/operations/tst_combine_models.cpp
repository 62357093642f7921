#include "core/mesh/mesh_builder.h"
#include "core/operations/model_command.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <map>
#include <random>

using namespace core;
using How = Insert::Combination;
using Place = Insert::Place;

namespace
{
Insert combined(TriangleMesh model, How how, const Vec3& centre = Vec3::Zero())
{
    return {std::move(model), Place::Centre, centre, how};
}

double volumeOf(const Mesh& mesh)
{
    return *checkMesh(extractMesh(mesh)).volume;
}

/// Returns the volume after the command; 0 if nothing would be left, -1 for other refusals.
double volumeAfter(const Mesh& mesh, const Insert& command)
{
    ModelChange change = applyToCopy(mesh, command);
    if (change.refusal == ModelRefusal::NothingLeft)
        return 0;
    if (change.refusal != ModelRefusal::None)
        return -1;
    Mesh after = mesh;
    after.swap(change.delta);
    return volumeOf(after);
}

TriangleMesh turned(TriangleMesh mesh, std::mt19937& random)
{
    std::normal_distribution<double> normal;
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    for (Vec3f& p : mesh.points)
        p = (rotation * p.cast<double>()).cast<float>();
    return mesh;
}
} // namespace

class TestCombineModels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void randomPlaces_addUp();
    void identicalSolids_data();
    void identicalSolids();
    void separateSolids();
    void insideAndAround();
    void touchingSolids_areJoined();
    void hollow_countsAsOutside();
    void faces_thatNothingMeetsKeepTheirSlots();
    void masksAndColours_areCarried();
    void largeTool_keepsTheLattice();
    void primitive_isInserted();
    void impossiblePrimitive_isRefused();
    void floor_isUnderTheModel();
    void unsoundModel_isRefused();
    void stopped_changesNothing();
};

void TestCombineModels::randomPlaces_addUp()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-70, 70), scale(0.2, 1.5);
    const std::unique_ptr<Mesh> meshes[] = {buildMesh(icosphere(3, 50)).mesh, buildMesh(shapes::cube(80)).mesh};
    const int count = byEffort(40, 300);
    int overlaps = 0;
    for (int i = 0; i < count; ++i) {
        Mesh mesh = *meshes[i % 2];
        const TriangleMesh shape = i % 4 < 2 ? icosphere(2, 40) : shapes::cube(60);
        const TriangleMesh other = turned(shapes::scaled(shape, static_cast<float>(scale(random))), random);
        const Vec3 centre(place(random), place(random), place(random));
        const double a = volumeOf(mesh), b = *checkMesh(other).volume;
        const std::uint64_t before = mesh.stateHash();
        std::map<How, double> volumes;
        for (const How how : {How::Join, How::Subtract, How::Intersect}) {
            ModelChange change = applyToCopy(mesh, combined(other, how, centre));
            const std::string where = std::to_string(i) + ", " + std::to_string(int(how)) + ", refusal " +
                                      std::to_string(int(change.refusal));
            QVERIFY2(change.refusal == ModelRefusal::None || change.refusal == ModelRefusal::NothingLeft,
                     where.c_str());
            if (change.refusal == ModelRefusal::None) {
                mesh.swap(change.delta);
                VERIFY_VALID(mesh);
                volumes[how] = volumeOf(mesh);
                mesh.swap(change.delta);
                QCOMPARE(mesh.stateHash(), before);
            }
        }
        overlaps += volumes[How::Intersect] > 0;
        const double tolerance = 1e-3 * (a + b);
        QVERIFY2(std::abs(volumes[How::Join] + volumes[How::Intersect] - a - b) < tolerance, std::to_string(i).c_str());
        QVERIFY2(std::abs(volumes[How::Subtract] + volumes[How::Intersect] - a) < tolerance, std::to_string(i).c_str());
    }
    QCOMPARE_GT(overlaps, count / 4);
}

void TestCombineModels::identicalSolids_data()
{
    QTest::addColumn<bool>("isBall");
    QTest::newRow("ball") << true;
    QTest::newRow("cube") << false;
}

void TestCombineModels::identicalSolids()
{
    QFETCH(bool, isBall);
    const TriangleMesh solid = isBall ? icosphere(3, 50) : shapes::cube(20);
    const auto mesh = buildMesh(solid).mesh;
    const TriangleMesh same = extractMesh(*mesh);
    for (const How how : {How::Join, How::Intersect}) {
        const ModelChange change = applyToCopy(*mesh, Insert{same, Place::AsItIs, Vec3::Zero(), how});
        QVERIFY(change.refusal == ModelRefusal::None && !change.changes);
    }
    QVERIFY(applyToCopy(*mesh, Insert{same, Place::AsItIs, Vec3::Zero(), How::Subtract}).refusal ==
            ModelRefusal::NothingLeft);
}

void TestCombineModels::separateSolids()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    const Vec3 beside(120, 0, 0);
    const double a = volumeOf(*mesh), b = *checkMesh(icosphere(2, 20)).volume;
    QVERIFY(std::abs(volumeAfter(*mesh, combined(icosphere(2, 20), How::Join, beside)) - a - b) < 1e-3 * a);
    const ModelChange subtracted = applyToCopy(*mesh, combined(icosphere(2, 20), How::Subtract, beside));
    QVERIFY(subtracted.refusal == ModelRefusal::None && !subtracted.changes);
    QVERIFY(applyToCopy(*mesh, combined(icosphere(2, 20), How::Intersect, beside)).refusal ==
            ModelRefusal::NothingLeft);
}

void TestCombineModels::insideAndAround()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    const double a = volumeOf(*mesh), b = *checkMesh(icosphere(2, 20)).volume;
    QVERIFY(!applyToCopy(*mesh, combined(icosphere(2, 20), How::Join)).changes);
    QVERIFY(std::abs(volumeAfter(*mesh, combined(icosphere(2, 20), How::Subtract)) - (a - b)) < 1e-3 * a);
    QVERIFY(std::abs(volumeAfter(*mesh, combined(icosphere(2, 20), How::Intersect)) - b) < 1e-3 * b);
    QVERIFY(!applyToCopy(*mesh, combined(icosphere(2, 90), How::Intersect)).changes);
    QVERIFY(applyToCopy(*mesh, combined(icosphere(2, 90), How::Subtract)).refusal == ModelRefusal::NothingLeft);
}

void TestCombineModels::touchingSolids_areJoined()
{
    const auto mesh = buildMesh(shapes::cube(20)).mesh;
    for (const Vec3& at : {Vec3(20, 0, 0), Vec3(20, 10, 5), Vec3(20, 20, 3), Vec3(20, 20, 20), Vec3(10, 0, 0)}) {
        ModelChange change = applyToCopy(*mesh, combined(shapes::cube(20), How::Join, at));
        QVERIFY(change.changes);
        mesh->swap(change.delta);
        VERIFY_VALID(*mesh);
        QVERIFY(std::abs(volumeOf(*mesh) - 8000 - std::min(at.maxCoeff(), 20.0) * 400) < 1);
        mesh->swap(change.delta);
    }
}

void TestCombineModels::hollow_countsAsOutside()
{
    const auto mesh = buildMesh(shapes::nestedSpheres(true)).mesh;
    const TriangleMesh small = shapes::scaled(icosphere(2, 1), 0.1f);
    QVERIFY(applyToCopy(*mesh, combined(small, How::Join)).changes);
    QVERIFY(!applyToCopy(*mesh, combined(small, How::Subtract)).changes);
}

void TestCombineModels::faces_thatNothingMeetsKeepTheirSlots()
{
    const auto mesh = buildMesh(icosphere(4, 50)).mesh;
    Mesh after = *mesh;
    ModelChange change = applyToCopy(*mesh, combined(shapes::cube(30), How::Subtract, {50, 0, 0}));
    after.swap(change.delta);
    for (const Slot f : mesh->faces()) {
        const bool isFar = std::ranges::all_of(mesh->corners(f), [&](Slot v) { return mesh->point(v).x() < 25; });
        if (isFar)
            QVERIFY(after.isFace(f) && after.corners(f) == mesh->corners(f));
    }
}

void TestCombineModels::masksAndColours_areCarried()
{
    TriangleMesh ball = icosphere(3, 50);
    ball.colors.assign(ball.points.size(), {10, 200, 30});
    ball.masks.assign(ball.points.size(), 77);
    const auto mesh = buildMesh(ball).mesh;
    TriangleMesh red = shapes::cube(40);
    red.colors.assign(red.points.size(), {255, 0, 0});
    for (const How how : {How::Join, How::Subtract}) {
        ModelChange change = applyToCopy(*mesh, combined(red, how, {50, 0, 0}));
        Mesh after = *mesh;
        after.swap(change.delta);
        std::size_t reds = 0;
        for (const Slot v : after.vertices()) {
            const bool isOld = mesh->isVertex(v) && mesh->point(v) == after.point(v);
            QCOMPARE(int(after.mask(v)), isOld ? 77 : 0);
            if (isOld)
                QVERIFY(after.color(v) == Rgb({10, 200, 30}));
            reds += after.color(v) == Rgb{255, 0, 0};
        }
        QCOMPARE_GE(reds, std::size_t(4));
    }
}

/// The lattice stays, so that nothing else of the model moves.
void TestCombineModels::largeTool_keepsTheLattice()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    for (const How how : {How::Subtract, How::Intersect}) {
        ModelChange change = applyToCopy(*mesh, combined(shapes::cube(400), how, {200, 0, 0}));
        QVERIFY(change.changes);
        Mesh after = *mesh;
        after.swap(change.delta);
        VERIFY_VALID(after);
        QVERIFY(after.lattice() == mesh->lattice());
        QVERIFY(std::abs(volumeOf(after) - volumeOf(*mesh) / 2) < 1e-3 * volumeOf(*mesh));
    }
    ModelChange change = applyToCopy(*mesh, combined(shapes::cube(6000), How::Subtract, {3000, 0, 0}));
    QVERIFY(change.changes);
    Mesh after = *mesh;
    const std::uint64_t before = after.stateHash();
    after.swap(change.delta);
    VERIFY_VALID(after);
    after.swap(change.delta);
    QCOMPARE(after.stateHash(), before);
}

void TestCombineModels::primitive_isInserted()
{
    const auto mesh = buildMesh(icosphere(4, 50)).mesh;
    Primitive hole;
    hole.kind = Primitive::Kind::Cylinder;
    hole.length(Primitive::Measure::Radius) = 10;
    hole.length(Primitive::Measure::Height) = 200;
    hole.axis = Vec3::UnitX();
    Insert drill = combined({}, How::Subtract);
    drill.primitive = hole;
    ModelChange change = applyToCopy(*mesh, drill);
    QVERIFY(change.changes);
    mesh->swap(change.delta);
    VERIFY_VALID(*mesh);
    QCOMPARE(checkMesh(extractMesh(*mesh)).genus, 1);
}

void TestCombineModels::impossiblePrimitive_isRefused()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    Insert insert;
    insert.primitive.emplace().kind = Primitive::Kind::Torus;
    insert.primitive->length(Primitive::Measure::TubeRadius) = 50;
    const ModelChange change = applyToCopy(*mesh, insert);
    QVERIFY(change.refusal == ModelRefusal::Primitive && !change.changes);
    QVERIFY(change.primitive.fault == PrimitiveFault::TubeTooThick);
}

void TestCombineModels::floor_isUnderTheModel()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    ModelChange change = applyToCopy(*mesh, Insert{shapes::cube(10), Place::Floor, {100, 3, 7}});
    Mesh after = *mesh;
    after.swap(change.delta);
    Box box;
    for (const Slot v : after.vertices())
        if (after.point(v).x() > 60)
            box.extend(after.point(v).cast<double>());
    QVERIFY(std::abs(box.min().y() - 3) < 1e-3 && std::abs(box.center().x() - 100) < 1e-3 &&
            std::abs(box.center().z() - 7) < 1e-3);
}

void TestCombineModels::unsoundModel_isRefused()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    QVERIFY(applyToCopy(*mesh, combined(shapes::openCone(12), How::Join)).refusal == ModelRefusal::Unsound);
    QVERIFY(applyToCopy(*mesh, combined(icosphere(1, mesh->lattice().unit() / 4), How::Join)).refusal ==
            ModelRefusal::FacesMeet);
}

void TestCombineModels::stopped_changesNothing()
{
    for (int stopAt = 1; stopAt <= 5; ++stopAt) {
        std::stop_source source;
        int calls = 0;
        const JobControl control{source.get_token(), [&](double) {
                                     if (++calls == stopAt)
                                         source.request_stop();
                                 }};
        const auto mesh = buildMesh(icosphere(3, 50)).mesh;
        const ModelChange change = applyToCopy(*mesh, combined(icosphere(3, 20), How::Join, {50, 0, 0}), control);
        QVERIFY(calls < stopAt || (!change.changes && change.delta.empty()));
    }
}

FETTLE_TEST(TestCombineModels)
#include "tst_combine_models.moc"
