#include "core/mesh/mesh_builder.h"
#include "core/operations/model_command.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <numbers>

using namespace core;

namespace
{
using mesh_asserts::volumeOf;

/// Returns the shape after a few random strokes, so that it has free slots and colours.
std::unique_ptr<Mesh> sculpted(const TriangleMesh& shape, std::uint64_t seed)
{
    std::unique_ptr<Mesh> mesh = buildMesh(shape).mesh;
    Sculptor sculptor(std::make_unique<Mesh>(*mesh));
    StrokeFuzzer random(seed);
    for (int i = 0; i < 4; ++i) {
        const Stroke stroke = random.stroke(sculptor.mesh());
        sculptor.beginStroke(stroke.settings);
        for (const StrokeSample& sample : stroke.samples)
            sculptor.addSample(sample);
        sculptor.endStroke();
    }
    return std::make_unique<Mesh>(sculptor.mesh());
}

/// Applies the command. Returns whether it changed the mesh.
bool apply(Mesh& mesh, const ModelCommand& command)
{
    ModelChange change = applyToCopy(mesh, command);
    if (change.changes)
        mesh.swap(change.delta);
    return change.changes;
}

Box boxOf(const Mesh& mesh)
{
    Box box;
    for (const Vec3f& p : extractMesh(mesh).points)
        box.extend(p.cast<double>());
    return box;
}

Eigen::Quaterniond turn(double degrees, const Vec3& axis)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis));
}

bool near(double a, double b, double share)
{
    return std::abs(a - b) <= share * std::abs(b);
}
} // namespace

/// Tests Move, Rotate, Scale, Mirror, Recentre and Fill on models that have been sculpted.
class TestTransform : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyCommand_keepsTheModelSound_data();
    void everyCommand_keepsTheModelSound();
    void copies_areCopies();
    void move_goesThereAndBack();
    void rotate_fourQuartersAreNone();
    void rotate_keepsTheVolume();
    void scale_scalesVolumeAndDetail();
    void scale_changesTheLatticeWhenItMust();
    void mirror_twiceIsNothing();
    void mirror_isTheMirrorImage();
    void recentre_putsTheMiddleAtTheOrigin();
    void fill_setsEveryColour();
    void nothing_isNoChange();
    void tooFar_isRefused();
    void tooLargeOrSmall_isRefused();
    void facesThatMeet_areRefusedWithTheirNumber();
    void facesThatMeet_goToNeighbouringLatticePoints();
    void reset_bringsTheStartBack();
    void stopped_changesNothing();
    void strokesAndCommands_areUndoneAndRedoneBitForBit_data();
    void strokesAndCommands_areUndoneAndRedoneBitForBit();
};

void TestTransform::everyCommand_keepsTheModelSound_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::newRow("ball") << icosphere(3, 50);
    QTest::newRow("off centre") << shapes::moved(icosphere(3, 50), {60, 10, -20});
    QTest::newRow("nested shells") << shapes::nestedSpheres(true);
    QTest::newRow("bowl") << clay::bowl();
    QTest::newRow("fingers") << clay::twoFingers(0.001);
    QTest::newRow("thin slab") << clay::slab(2, 0.001, 8);
}

void TestTransform::everyCommand_keepsTheModelSound()
{
    QFETCH(TriangleMesh, shape);
    const auto mesh = sculpted(shape, 7);
    VERIFY_VALID(*mesh);
    const double size = boxOf(*mesh).sizes().maxCoeff();
    const ModelCommand commands[] = {Move{Vec3(0.31, -0.2, 0.1) * size},
                                     Rotate{turn(37, Vec3(1, 2, 3).normalized())},
                                     Scale{0.3},
                                     Scale{25.4},
                                     Scale{1e-4},
                                     Mirror{0},
                                     Mirror{1},
                                     Mirror{2},
                                     Recentre{},
                                     Fill{{10, 20, 30}}};
    for (const ModelCommand& command : commands) {
        const std::uint64_t before = mesh->stateHash();
        ModelChange change = applyToCopy(*mesh, command);
        QVERIFY(change.refusal == ModelRefusal::None && change.changes);
        QCOMPARE(mesh->stateHash(), before); // the command worked on a copy
        mesh->swap(change.delta);
        const std::uint64_t after = mesh->stateHash();
        QVERIFY(after != before);
        VERIFY_VALID(*mesh);
        mesh->swap(change.delta);
        QCOMPARE(mesh->stateHash(), before);
        mesh->swap(change.delta);
        QCOMPARE(mesh->stateHash(), after);
    }
}

void TestTransform::copies_areCopies()
{
    const auto mesh = sculpted(clay::bowl(), 3);
    const Mesh copy(*mesh);
    QCOMPARE(copy.stateHash(), mesh->stateHash());
    VERIFY_LINKED(copy);
}

void TestTransform::move_goesThereAndBack()
{
    const auto mesh = sculpted(icosphere(3, 50), 11);
    const std::uint64_t before = mesh->stateHash();
    StrokeFuzzer random(12);
    for (int i = 0; i < 5; ++i) {
        const Vec3 by = mesh->lattice().snap(40 * random.direction()).cast<double>();
        QVERIFY(apply(*mesh, Move{by}));
        QVERIFY(mesh->stateHash() != before);
        QVERIFY(apply(*mesh, Move{-by}));
        QCOMPARE(mesh->stateHash(), before);
    }
}

void TestTransform::rotate_fourQuartersAreNone()
{
    const auto mesh = sculpted(clay::bowl(), 5);
    for (const Vec3& axis : {Vec3::UnitX().eval(), Vec3::UnitY().eval(), Vec3::UnitZ().eval()}) {
        const std::uint64_t before = mesh->stateHash();
        for (int quarter = 0; quarter < 4; ++quarter)
            QVERIFY(apply(*mesh, Rotate{turn(90, axis)}));
        QCOMPARE(mesh->stateHash(), before);
    }
}

void TestTransform::rotate_keepsTheVolume()
{
    const auto mesh = sculpted(clay::bowl(), 5);
    const double before = volumeOf(*mesh);
    QVERIFY(apply(*mesh, Rotate{turn(33, Vec3(3, -1, 2).normalized())}));
    QVERIFY(near(volumeOf(*mesh), before, 1e-5));
}

void TestTransform::scale_scalesVolumeAndDetail()
{
    for (const double factor : {0.5, 2.0, 3.7, 1e-3, 1e3}) {
        const auto mesh = sculpted(icosphere(3, 50), 21);
        const double volume = volumeOf(*mesh), detail = mesh->uniformDetail();
        QVERIFY(apply(*mesh, Scale{factor}));
        QVERIFY(near(volumeOf(*mesh), volume * factor * factor * factor, 1e-5));
        QVERIFY(near(mesh->uniformDetail(), detail * factor, 1e-12));
    }
}

void TestTransform::scale_changesTheLatticeWhenItMust()
{
    const auto mesh = sculpted(icosphere(3, 50), 21);
    const Lattice before = mesh->lattice();
    QVERIFY(apply(*mesh, Scale{2}));
    QVERIFY(mesh->lattice() == before);
    QVERIFY(apply(*mesh, Scale{100}));
    QVERIFY(mesh->lattice().exponent() < before.exponent());
    QVERIFY(8 * boxOf(*mesh).max().maxCoeff() <= 8 * mesh->lattice().halfVolume());
    QVERIFY(apply(*mesh, Scale{1e-4}));
    QVERIFY(mesh->lattice().exponent() > before.exponent());
    VERIFY_VALID(*mesh);
}

void TestTransform::mirror_twiceIsNothing()
{
    const auto mesh = sculpted(clay::twoFingers(0.01), 8);
    const std::uint64_t before = mesh->stateHash();
    for (const int axis : {0, 1, 2}) {
        QVERIFY(apply(*mesh, Mirror{axis}));
        QVERIFY(mesh->stateHash() != before);
        QVERIFY(apply(*mesh, Mirror{axis}));
        QCOMPARE(mesh->stateHash(), before);
    }
}

void TestTransform::mirror_isTheMirrorImage()
{
    const auto mesh = sculpted(clay::bowl(), 8);
    const TriangleMesh before = extractMesh(*mesh);
    const double volume = volumeOf(*mesh);
    QVERIFY(apply(*mesh, Mirror{1}));
    const TriangleMesh after = extractMesh(*mesh);
    QVERIFY(after.colors == before.colors);
    for (std::size_t v = 0; v < before.points.size(); ++v)
        QVERIFY(after.points[v] == before.points[v].cwiseProduct(Vec3f(1, -1, 1)));
    QVERIFY(near(volumeOf(*mesh), volume, 1e-12)); // positive, so the faces still face outwards
}

void TestTransform::recentre_putsTheMiddleAtTheOrigin()
{
    const auto mesh = sculpted(shapes::moved(icosphere(3, 50), {40, -70, 20}), 8);
    const Vec3 size = boxOf(*mesh).sizes();
    QVERIFY(apply(*mesh, Recentre{}));
    QVERIFY(boxOf(*mesh).center().cwiseAbs().maxCoeff() <= mesh->lattice().unit());
    QVERIFY(boxOf(*mesh).sizes() == size);
    QVERIFY(!apply(*mesh, Recentre{}));
}

void TestTransform::fill_setsEveryColour()
{
    const auto mesh = sculpted(icosphere(3, 50), 8);
    apply(*mesh, core::MaskOperation{core::MaskOperation::Kind::Clear, {}}); // masked clay keeps its colour
    const TriangleMesh before = extractMesh(*mesh);
    const Rgb red{200, 10, 10};
    QVERIFY(apply(*mesh, Fill{red}));
    const TriangleMesh after = extractMesh(*mesh);
    QVERIFY(std::ranges::all_of(after.colors, [&](Rgb c) { return c == red; }));
    QCOMPARE(after.colors.size(), after.points.size());
    QVERIFY(after.points == before.points && after.triangles == before.triangles);
}

void TestTransform::nothing_isNoChange()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    for (const ModelCommand& command :
         {ModelCommand(Move{}), ModelCommand(Rotate{}), ModelCommand(Scale{1}), ModelCommand(Fill{})}) {
        const ModelChange change = applyToCopy(*mesh, command);
        QVERIFY(!change.changes && change.delta.empty());
        QVERIFY(change.refusal == ModelRefusal::None);
    }
}

void TestTransform::tooFar_isRefused()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    const ModelChange change = applyToCopy(*mesh, Move{{0, 500, 0}});
    QVERIFY(change.refusal == ModelRefusal::TooFar && !change.changes);
    QVERIFY(apply(*mesh, Move{{0, 390, 0}})); // beyond half of halfVolume(), so a coarser lattice is chosen
    VERIFY_VALID(*mesh);
    QVERIFY(mesh->lattice().halfVolume() > 2 * 440);
}

void TestTransform::tooLargeOrSmall_isRefused()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    QVERIFY(applyToCopy(*mesh, Scale{1e8}).refusal == ModelRefusal::TooLarge);
    QVERIFY(applyToCopy(*mesh, Scale{1e-9}).refusal == ModelRefusal::TooLarge);
}

/// A slab two lattice units thick cannot be scaled to less than one unit.
void TestTransform::facesThatMeet_areRefusedWithTheirNumber()
{
    const Lattice lattice(16);
    const auto mesh = mesh_asserts::sculptable(clay::slab(60, 2 * lattice.unit(), 8), lattice);
    VERIFY_VALID(*mesh);
    const std::uint64_t before = mesh->stateHash();
    const ModelChange change = applyToCopy(*mesh, Scale{0.3});
    QVERIFY(change.refusal == ModelRefusal::FacesMeet && !change.changes && change.delta.empty());
    QVERIFY(change.faces > 0);
    QCOMPARE(mesh->stateHash(), before);
}

/// The slab is so thin that rotation can make faces meet on the lattice, but thick enough that neighbouring lattice
/// points resolve it.
void TestTransform::facesThatMeet_goToNeighbouringLatticePoints()
{
    const Lattice lattice(16);
    int done = 0;
    for (int degrees = 5; degrees < 90; degrees += 10) {
        const auto mesh = mesh_asserts::sculptable(clay::slab(60, 4 * lattice.unit(), 8), lattice);
        const std::uint64_t before = mesh->stateHash();
        const ModelChange change = applyToCopy(*mesh, Rotate{turn(degrees, Vec3(2, 1, 3).normalized())});
        QVERIFY(change.changes == (change.refusal == ModelRefusal::None));
        if (change.changes) {
            MeshDelta delta = change.delta;
            mesh->swap(delta);
            VERIFY_VALID(*mesh);
            mesh->swap(delta);
            ++done;
        }
        QCOMPARE(mesh->stateHash(), before);
    }
    QVERIFY(done > 0);
}

/// Reset restores every slot. Its delta contains only elements that were sculpted.
void TestTransform::reset_bringsTheStartBack()
{
    Sculptor sculptor(buildMesh(icosphere(5, 50)).mesh);
    const auto start = snapshotOf(sculptor.mesh());
    const std::uint64_t before = sculptor.mesh().stateHash();
    QVERIFY(!applyToCopy(sculptor.mesh(), Reset{start}).changes);
    StrokeSettings settings;
    settings.radius = 8;
    sculptor.beginStroke(settings);
    StrokeSample sample;
    sample.position = {50, 0, 0};
    sculptor.addSample(sample);
    const MeshDelta stroke = sculptor.endStroke();
    ModelChange change = applyToCopy(sculptor.mesh(), Reset{start});
    QVERIFY(change.changes);
    QVERIFY(change.delta.vertices.size() <= stroke.vertices.size() && change.delta.faces.size() <= stroke.faces.size());
    sculptor.swap(change.delta);
    QCOMPARE(sculptor.mesh().stateHash(), before);
    QVERIFY(sculptor.indexIsConsistent());
    VERIFY_VALID(sculptor.mesh());
}

void TestTransform::stopped_changesNothing()
{
    const auto mesh = sculpted(icosphere(4, 50), 2);
    std::stop_source source;
    int calls = 0;
    const JobControl control{source.get_token(), [&](double) {
                                 ++calls;
                                 source.request_stop();
                             }};
    const ModelChange change = applyToCopy(*mesh, Rotate{turn(20, Vec3::UnitX())}, control);
    QCOMPARE(calls, 1);
    QVERIFY(!change.changes && change.delta.empty() && change.refusal == ModelRefusal::None);
}

void TestTransform::strokesAndCommands_areUndoneAndRedoneBitForBit_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::addColumn<std::uint64_t>("seed");
    for (std::uint64_t seed = 1; seed <= byEffort(1u, 2u, 40u); ++seed) {
        QTest::addRow("ball %d", int(seed)) << icosphere(3, 50) << seed;
        QTest::addRow("fingers %d", int(seed)) << clay::twoFingers(0.05) << seed;
        QTest::addRow("nested shells %d", int(seed)) << shapes::nestedSpheres(true) << seed;
    }
}

void TestTransform::strokesAndCommands_areUndoneAndRedoneBitForBit()
{
    QFETCH(TriangleMesh, shape);
    QFETCH(std::uint64_t, seed);
    Sculptor sculptor(buildMesh(shape).mesh);
    const auto start = snapshotOf(sculptor.mesh());
    const std::uint64_t startState = sculptor.mesh().stateHash();
    StrokeFuzzer random(seed);
    const auto command = [&]() -> ModelCommand {
        const double size = boxOf(sculptor.mesh()).sizes().maxCoeff();
        switch (random.below(9)) {
        case 0:
            return Move{random.uniform(0, 0.5) * size * random.direction()};
        case 1:
            return Rotate{turn(random.uniform(0, 360), random.direction())};
        case 2:
            return Scale{random.uniform(0.2, 4)};
        case 3:
            return Mirror{int(random.below(3))};
        case 4:
            return Fill{{std::uint8_t(random.below(256)), 3, 4}};
        case 5:
            return RemeshUniformly{sculptor.mesh().uniformDetail() * random.uniform(0.8, 1.5)};
        case 6:
            return Insert{icosphere(2, size * random.uniform(0.05, 0.3))};
        case 7:
            return Reset{start};
        default:
            return Recentre{};
        }
    };
    std::vector<MeshDelta> deltas;
    std::vector<std::uint64_t> states = {sculptor.mesh().stateHash()};
    for (int i = 0; i < 24; ++i) {
        MeshDelta delta;
        const ModelCommand next = command();
        if (random.below(2) == 0) {
            const Stroke stroke = random.stroke(sculptor.mesh());
            sculptor.beginStroke(stroke.settings);
            for (const StrokeSample& sample : stroke.samples)
                sculptor.addSample(sample);
            delta = sculptor.endStroke();
        } else {
            ModelChange change = applyToCopy(sculptor.mesh(), next);
            if (!change.changes)
                continue;
            sculptor.swap(change.delta);
            delta = std::move(change.delta);
            if (std::holds_alternative<Reset>(next))
                QCOMPARE(sculptor.mesh().stateHash(), startState);
        }
        VERIFY_VALID(sculptor.mesh());
        QVERIFY(sculptor.indexIsConsistent());
        deltas.push_back(std::move(delta));
        states.push_back(sculptor.mesh().stateHash());
    }
    for (std::size_t i = deltas.size(); i > 0; --i) {
        sculptor.swap(deltas[i - 1]);
        QCOMPARE(sculptor.mesh().stateHash(), states[i - 1]);
        QVERIFY(sculptor.indexIsConsistent());
    }
    for (std::size_t i = 0; i < deltas.size(); ++i) {
        sculptor.swap(deltas[i]);
        QCOMPARE(sculptor.mesh().stateHash(), states[i + 1]);
        QVERIFY(sculptor.indexIsConsistent());
    }
    VERIFY_VALID(sculptor.mesh());
}

FETTLE_TEST(TestTransform)
#include "tst_transform.moc"
