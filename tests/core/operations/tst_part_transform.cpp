#include "core/mesh/mesh_builder.h"
#include "core/operations/model_command.h"
#include "core/operations/transform.h"
#include "core/operations/transform_region.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/environment.h"
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

Eigen::Quaterniond rotationBy(double degrees, const Vec3& axis)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()));
}

/// Sets the mask of each vertex by its position.
template <class Mask> void maskBy(Mesh& mesh, Mask mask)
{
    mesh.beginStroke();
    for (const Slot v : mesh.vertices())
        mesh.setMask(v, mask(mesh.point(v)));
    mesh.endStroke();
}

/// Returns an upright bar from y = -50 to 50, whose lower end is masked. `soft`: the mask ends in a ramp of 20 mm.
std::unique_ptr<Mesh> maskedBar(bool soft)
{
    Primitive capsule;
    capsule.kind = Primitive::Kind::Capsule;
    capsule.length(Primitive::Measure::Height) = 100;
    capsule.length(Primitive::Measure::Radius) = 8;
    std::unique_ptr<Mesh> bar = buildMesh(makePrimitive(capsule).mesh.value()).mesh;
    maskBy(*bar, [soft](const Vec3f& p) {
        const double share = soft ? (10.0 - p.y()) / 20 : p.y() < 0 ? 1 : 0;
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
    });
    return bar;
}

ModelChange transformed(Mesh& mesh, const ModelCommand& command)
{
    const std::uint64_t before = mesh.stateHash();
    ModelChange change = applyToCopy(mesh, command);
    if (!change.changes)
        return change;
    mesh.swap(change.delta);
    mesh.swap(change.delta);
    if (mesh.stateHash() != before)
        qFatal("undo does not restore the mesh");
    mesh.swap(change.delta);
    return change;
}

/// Returns the largest distance from a vertex to where the transformation should have put it, in lattice units.
double largestError(const Mesh& before, const Mesh& after, const Transform& transform)
{
    double largest = 0;
    for (const Slot v : before.vertices()) {
        const Vec3 place = transform.placeOf(before.point(v).cast<double>(), before.freedom(v));
        largest = std::max(largest, (after.point(v).cast<double>() - place).cwiseAbs().maxCoeff());
    }
    return largest / after.lattice().unit();
}
} // namespace

/// Tests Transform, alone and of parts that are masked in part, and the region that it moves.
class TestPartTransform : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void unmasked_movesAsAWhole_data();
    void unmasked_movesAsAWhole();
    void scale_goesAlongItsOwnAxes();
    void masked_staysBitForBit();
    void softMask_bendsAlongAnArc();
    void axes_turnWithTheWholePart();
    void allMasked_isRefused();
    void fold_isRefused();
    void region_isWhatMoves();
    void region_turnsAboutTheBorder();
    void randomTransforms_keepTheModelSound();
};

void TestPartTransform::unmasked_movesAsAWhole_data()
{
    QTest::addColumn<Transform>("transform");
    QTest::newRow("move") << Transform{{1, 2, 3}, {0.5, -0.7, 0.2}};
    QTest::newRow("rotate") << Transform{{1, 0, 0}, Vec3::Zero(), rotationBy(70, {1, 2, -1})};
    QTest::newRow("scale") << Transform{{0, 1, 0}, Vec3::Zero(), rotationBy(0, Vec3::UnitX()), {1.5, 0.5, 2}};
    QTest::newRow("all") << Transform{
        {0.3, 0.4, 0.5}, {-0.9, 0.1, 0}, rotationBy(-33, {0, 1, 1}), {1.2, 1.2, 0.7}, rotationBy(20, Vec3::UnitZ())};
}

void TestPartTransform::unmasked_movesAsAWhole()
{
    QFETCH(Transform, transform);
    const std::unique_ptr<Mesh> mesh = buildMesh(clay::twoFingers(1)).mesh;
    const Mesh before = *mesh;
    QVERIFY(transformed(*mesh, transform).changes);
    VERIFY_VALID(*mesh);
    QVERIFY(largestError(before, *mesh, transform) <= 2);
    const double volume = transform.scale.prod() * volumeOf(before);
    QVERIFY(std::abs(volumeOf(*mesh) - volume) < 1e-4 * volume);
}

/// A bar along a diagonal, scaled along it, becomes longer and not thicker.
void TestPartTransform::scale_goesAlongItsOwnAxes()
{
    const std::unique_ptr<Mesh> mesh = maskedBar(false);
    maskBy(*mesh, [](const Vec3f&) { return std::uint8_t(0); });
    const Eigen::Quaterniond lean = rotationBy(35, {1, 0, 1});
    QVERIFY(transformed(*mesh, Transform{Vec3::Zero(), Vec3::Zero(), lean}).changes);
    QVERIFY(transformed(*mesh, Transform{Vec3::Zero(), Vec3::Zero(), rotationBy(0, Vec3::UnitX()), {1, 3, 1}, lean})
                .changes);
    VERIFY_VALID(*mesh);
    double farthest = 0, thickest = 0;
    for (const Slot v : mesh->vertices()) {
        const Vec3 p = lean.conjugate() * mesh->point(v).cast<double>();
        farthest = std::max(farthest, p.y());
        thickest = std::max(thickest, std::hypot(p.x(), p.z()));
    }
    QVERIFY(std::abs(farthest - 150) < 0.01);
    QVERIFY(std::abs(thickest - 8) < 0.01);
}

void TestPartTransform::masked_staysBitForBit()
{
    const std::unique_ptr<Mesh> mesh = maskedBar(false);
    const Mesh before = *mesh;
    const Transform transform{{0, 0, 0}, {0, 5, 0}, rotationBy(30, Vec3::UnitX())};
    QVERIFY(transformed(*mesh, transform).changes);
    VERIFY_VALID(*mesh);
    QVERIFY(mesh->lattice() == before.lattice());
    for (const Slot v : mesh->vertices())
        QVERIFY(before.freedom(v) > 0 || mesh->point(v) == before.point(v));
    QVERIFY(largestError(before, *mesh, transform) <= 2);
}

/// A soft mask makes the turn a share of the angle, so that no vertex comes nearer to the axis.
void TestPartTransform::softMask_bendsAlongAnArc()
{
    const std::unique_ptr<Mesh> mesh = maskedBar(true);
    const Mesh before = *mesh;
    const Vec3 axis = Vec3::UnitZ();
    QVERIFY(transformed(*mesh, Transform{Vec3::Zero(), Vec3::Zero(), rotationBy(60, axis)}).changes);
    VERIFY_VALID(*mesh);
    const auto fromAxis = [](const Vec3f& p) { return std::hypot(p.x(), p.y()); };
    int soft = 0;
    for (const Slot v : mesh->vertices()) {
        soft += before.freedom(v) > 0 && before.freedom(v) < 1;
        QVERIFY(std::abs(fromAxis(mesh->point(v)) - fromAxis(before.point(v))) < 4 * mesh->lattice().unit());
    }
    QVERIFY(soft > 100);
}

void TestPartTransform::axes_turnWithTheWholePart()
{
    const std::unique_ptr<Mesh> mesh = maskedBar(true);
    const Eigen::Quaterniond rotation = rotationBy(25, {1, 1, 0});
    QVERIFY(transformed(*mesh, Transform{Vec3::Zero(), Vec3::Zero(), rotation}).changes);
    QVERIFY(mesh->frame().parts.all().front().axes.isApprox(Eigen::Quaterniond::Identity())); // only a piece has turned
    maskBy(*mesh, [](const Vec3f&) { return std::uint8_t(0); });
    QVERIFY(transformed(*mesh, Transform{Vec3::Zero(), Vec3::Zero(), rotation}).changes);
    QVERIFY(transformed(*mesh, Rotate{rotation}).changes);
    QVERIFY(mesh->frame().parts.all().front().axes.isApprox(rotation * rotation, 1e-12));
    QVERIFY(transformRegionOf(*mesh, 0).axes.isApprox(rotation * rotation, 1e-12));
}

void TestPartTransform::allMasked_isRefused()
{
    const std::unique_ptr<Mesh> mesh = maskedBar(false);
    maskBy(*mesh, [](const Vec3f&) { return std::uint8_t(255); });
    const ModelChange change = transformed(*mesh, Transform{{}, {0, 1, 0}});
    QVERIFY(change.refusal == ModelRefusal::AllMasked && !change.changes);
    QVERIFY(transformRegionOf(*mesh, 0).box.isEmpty());
}

/// A turn by which the free end would cross the masked one is refused.
void TestPartTransform::fold_isRefused()
{
    const std::unique_ptr<Mesh> mesh = maskedBar(false);
    const ModelChange change =
        transformed(*mesh, Transform{Vec3::Zero(), Vec3::Zero(), rotationBy(170, Vec3::UnitX())});
    QVERIFY(change.refusal == ModelRefusal::Folded && !change.changes);
    QVERIFY(change.faces > 0);
}

void TestPartTransform::region_isWhatMoves()
{
    const std::unique_ptr<Mesh> mesh = maskedBar(true);
    const TransformRegion region = transformRegionOf(*mesh, 0);
    std::size_t free = 0, all = 0;
    for (const Slot v : mesh->vertices()) {
        free += mesh->freedom(v) > 0;
        ++all;
    }
    QCOMPARE(region.vertices->slots.size(), free);
    for (std::size_t i = 0; i < free; ++i) {
        QVERIFY(region.box.contains(mesh->point(region.vertices->slots[i]).cast<double>()));
        QCOMPARE(int(region.vertices->weights[i]), 255 - mesh->mask(region.vertices->slots[i]));
    }
    QVERIFY(region.whole.isApprox(boxOf(*mesh)) && region.whole.contains(region.box));
    QVERIFY(region.all->slots.size() == all && all > free);
    QVERIFY(transformRegionOf(*mesh, 7).vertices->slots.empty()); // there is no such part
}

void TestPartTransform::region_turnsAboutTheBorder()
{
    const std::unique_ptr<Mesh> mesh = maskedBar(false);
    QVERIFY(transformRegionOf(*mesh, 0).centre.norm() < 1); // the middle of the cut through the bar
    maskBy(*mesh, [](const Vec3f&) { return std::uint8_t(0); });
    QVERIFY(transformRegionOf(*mesh, 0).centre.isApprox(transformRegionOf(*mesh, 0).box.center()));
}

/// Random transformations of a model with a random mask leave it sound, or as it was.
void TestPartTransform::randomTransforms_keepTheModelSound()
{
    const std::uint64_t first = numberFromEnvironment("FETTLE_SEED", 1);
    for (std::uint64_t seed = first; seed < first + byEffort(8u, 20u, 300u); ++seed) {
        StrokeFuzzer random(seed);
        const std::unique_ptr<Mesh> mesh = buildMesh(seed % 2 == 0 ? clay::bowl() : clay::twoFingers(2)).mesh;
        const Vec3 along = random.direction();
        const double width = random.uniform(0.01, 30), offset = random.uniform(-20, 20);
        maskBy(*mesh, [&](const Vec3f& p) {
            const double share = (p.cast<double>().dot(along) - offset) / width;
            return static_cast<std::uint8_t>(255 * std::clamp(share, 0.0, 1.0));
        });
        for (int i = 0; i < 4; ++i) {
            const auto factor = [&] { return std::exp(random.uniform(-0.7, 0.7)); };
            const Transform transform{10 * random.direction(),
                                      random.uniform(0, 8) * random.direction(),
                                      rotationBy(random.uniform(-90, 90), random.direction()),
                                      {factor(), factor(), factor()},
                                      rotationBy(random.uniform(0, 90), random.direction())};
            const std::uint64_t before = mesh->stateHash();
            const ModelChange change = transformed(*mesh, transform);
            QVERIFY2(change.changes == (mesh->stateHash() != before), qPrintable(QStringLiteral("seed %1").arg(seed)));
            VERIFY_VALID(*mesh);
        }
    }
}

FETTLE_TEST(TestPartTransform, QCoreApplication)

#include "tst_part_transform.moc"
