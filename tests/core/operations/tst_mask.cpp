// Tests that masked areas do not change, whichever tool is used on them: they do not move, are not remeshed, do not
// fuse and take no colour.
#include "core/analysis/mesh_check.h"
#include "core/decimation/decimate.h"
#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/mask_operations.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numbers>
#include <set>

using core::DabReport;
using core::MaskOperation;
using core::Mesh;
using core::Rgb;
using core::Sculptor;
using core::Slot;
using core::StrokeSettings;
using core::Tool;
using core::Vec3;

namespace
{
using clay::ball;
using clay::ballRadius;
using clay::stroke;
using mesh_asserts::isSound;
using std::numbers::pi;
using How = MaskOperation::Kind;

StrokeSettings settingsOf(Tool tool, double radius, int falloff = 4)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = radius;
    settings.falloff = falloff;
    return settings;
}

/// Masks a disc completely with one dab.
void maskAt(Sculptor& sculptor, const Vec3& at, double radius)
{
    stroke(sculptor, settingsOf(Tool::Mask, radius, 0), {at});
}

void change(Sculptor& sculptor, const core::ModelCommand& command)
{
    core::ModelChange change = applyToCopy(sculptor.mesh(), command);
    sculptor.swap(change.delta);
}

/// Returns the point of the ball in the plane y = 0 at an angle from the z axis.
Vec3 onBall(double degrees)
{
    return ballRadius * Vec3(std::sin(degrees * pi / 180), 0, std::cos(degrees * pi / 180));
}

std::vector<Vec3> arc(double from, double to, int samples)
{
    std::vector<Vec3> path;
    for (int i = 0; i < samples; ++i)
        path.push_back(onBall(from + (to - from) * i / (samples - 1)));
    return path;
}

template <class Visit> void forEachVertex(const Mesh& mesh, Visit visit)
{
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (mesh.isVertex(v))
            visit(v);
    }
}

using Point = std::array<float, 3>;
Point pointOf(const Mesh& mesh, Slot v)
{
    return {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
}

/// Returns the points of those faces whose corners are all fully masked.
std::set<std::set<Point>> maskedFaces(const Mesh& mesh)
{
    std::set<std::set<Point>> faces;
    for (Slot f = 0; f < mesh.slots().faces; ++f) {
        if (!mesh.isFace(f) || !std::ranges::all_of(mesh.corners(f), [&](Slot v) { return mesh.mask(v) == 255; }))
            continue;
        const core::Triangle& t = mesh.corners(f);
        faces.insert({pointOf(mesh, t[0]), pointOf(mesh, t[1]), pointOf(mesh, t[2])});
    }
    return faces;
}

std::set<Point> maskedPoints(const Mesh& mesh)
{
    std::set<Point> points;
    forEachVertex(mesh, [&](Slot v) {
        if (mesh.mask(v) == 255)
            points.insert(pointOf(mesh, v));
    });
    return points;
}

std::size_t maskedCount(const Mesh& mesh)
{
    std::size_t count = 0;
    forEachVertex(mesh, [&](Slot v) { count += mesh.isMasked(v); });
    return count;
}

std::vector<int> masks(const Mesh& mesh)
{
    std::vector<int> all;
    forEachVertex(mesh, [&](Slot v) { all.push_back(mesh.mask(v)); });
    return all;
}

/// Returns the largest distance from the ball's centre among vertices near this angle from the z axis.
double highestAt(const Mesh& mesh, double degrees, double within)
{
    double most = 0;
    forEachVertex(mesh, [&](Slot v) {
        const Vec3 p = mesh.point(v).cast<double>();
        if ((p.normalized() - onBall(degrees).normalized()).norm() < within)
            most = std::max(most, p.norm());
    });
    return most;
}
} // namespace

class TestMask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void painted_addsUpAndIsWipedAway();
    void masked_stays_data();
    void masked_stays();
    void masked_staysWhenTheModelIsRemeshed();
    void half_movesHalf();
    void edge_isRefined();
    void masked_doesNotFuse();
    void masked_takesNoColour();
    void split_takesTheMean();
    void stroke_isUndone();
    void saved_comesBack();
    void symmetrized_isItsOwnImage();
    void flattened_staysMasked();
    void decimated_goesAlong();
    void inverted_twiceIsNothing();
    void blurred_isSofterAndSharpenedHarder();
    void grown_holdsAndShrunkIsHeld();
    void cavity_isWhatIsHollow();
    void color_isWhatIsOfIt();
    void part_isAllOfIt();
    void symmetric_whereTheMaskIs();
    void footprint_showsWhatIsFree();
};

void TestMask::painted_addsUpAndIsWipedAway()
{
    const auto sculptor = ball(4);
    StrokeSettings settings = settingsOf(Tool::Mask, 15);
    settings.strength = 0.25;
    const core::Mesh& mesh = sculptor->mesh();
    const std::uint64_t shape = mesh.meshHash();
    const auto most = [&] { return std::ranges::max(masks(mesh)); };
    for (const int expected : {64, 128, 192, 255, 255}) {
        stroke(*sculptor, settings, {onBall(0)});
        QVERIFY2(std::abs(most() - expected) <= 8, qPrintable(QString::number(most())));
    }
    QCOMPARE(mesh.meshHash(), shape);
    settings.inverted = true;
    settings.strength = 1;
    settings.falloff = 0;
    stroke(*sculptor, settings, {onBall(0)});
    QCOMPARE(most(), 0);
}

void TestMask::masked_stays_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<bool>("inverted");
    for (std::size_t i = 0; i < core::toolNames().size(); ++i) {
        const auto tool = static_cast<Tool>(i);
        if (core::paintsAttribute(tool))
            continue;
        QTest::addRow("%s", core::toolNames()[i].data()) << tool << false;
        if (core::hasInverse(tool))
            QTest::addRow("%s, inverted", core::toolNames()[i].data()) << tool << true;
    }
}

/// Sculpts back and forth across the mask's edge, with fusion and finer than the ball's mesh. No masked face may
/// change.
void TestMask::masked_stays()
{
    QFETCH(Tool, tool);
    QFETCH(bool, inverted);
    const auto sculptor = ball();
    maskAt(*sculptor, onBall(0), 16);
    const std::set<std::set<Point>> faces = maskedFaces(sculptor->mesh());
    QVERIFY(faces.size() > 50);
    StrokeSettings settings = settingsOf(tool, 10);
    settings.inverted = inverted;
    settings.detail = tool == Tool::Stamp ? 3 : 0.8; // stamps refine the mesh more by themselves
    for (int pass = 0; pass < 2; ++pass) {
        stroke(*sculptor, settings, arc(-25, 30, 10));
        stroke(*sculptor, settings, arc(30, -25, 10));
    }
    const std::set<std::set<Point>> after = maskedFaces(sculptor->mesh());
    QVERIFY(std::ranges::includes(after, faces));
    const Mesh untouched = ball()->mesh();
    QVERIFY(sculptor->mesh().meshHash() != untouched.meshHash());
    QVERIFY(isSound(*sculptor));
}

void TestMask::masked_staysWhenTheModelIsRemeshed()
{
    const auto sculptor = ball(4);
    maskAt(*sculptor, onBall(0), 20);
    const std::set<std::set<Point>> faces = maskedFaces(sculptor->mesh());
    for (const double detail : {4.0, 12.0}) {
        core::ModelChange change = applyToCopy(sculptor->mesh(), core::RemeshUniformly{detail});
        QVERIFY(change.changes);
        sculptor->swap(change.delta);
        QVERIFY(std::ranges::includes(maskedFaces(sculptor->mesh()), faces));
        QVERIFY(isSound(*sculptor));
    }
}

void TestMask::half_movesHalf()
{
    const auto free = ball(), half = ball();
    StrokeSettings mask = settingsOf(Tool::Mask, 30, 0);
    mask.strength = 0.4;
    stroke(*half, mask, {onBall(0)});
    for (Sculptor* sculptor : {free.get(), half.get()})
        stroke(*sculptor, settingsOf(Tool::Pull, 12), {onBall(0)});
    const double whole = highestAt(free->mesh(), 0, 0.2) - ballRadius,
                 part = highestAt(half->mesh(), 0, 0.2) - ballRadius;
    QVERIFY2(std::abs(part / whole - 0.6) < 0.02, qPrintable(QString::number(part / whole)));
}

/// The area between masked and free vertices is stretched, so it must be refined.
void TestMask::edge_isRefined()
{
    const auto sculptor = ball();
    maskAt(*sculptor, onBall(0), 16);
    const StrokeSettings settings = settingsOf(Tool::Pull, 10);
    for (int i = 0; i < 10; ++i)
        stroke(*sculptor, settings, {1.0 * highestAt(sculptor->mesh(), 24, 0.05) / ballRadius * onBall(24)});
    const double detail = core::edgeBounds(settings.radius, settings.detail).detail;
    const Mesh& mesh = sculptor->mesh();
    double longest = 0;
    forEachVertex(mesh, [&](Slot v) {
        mesh.forEachOutgoing(v, [&](Slot h) {
            if (!mesh.isMasked(v) || !mesh.isMasked(mesh.to(h)))
                longest = std::max(longest, double((mesh.point(mesh.to(h)) - mesh.point(v)).norm()));
        });
    });
    QVERIFY2(longest < 2 * detail, qPrintable(QString::number(longest / detail)));
}

/// One finger is pulled towards the masked other one. Without the mask they fuse; with it they stay two parts.
void TestMask::masked_doesNotFuse()
{
    for (const bool masked : {false, true}) {
        Sculptor sculptor(mesh_asserts::sculptable(clay::twoFingers(0.1)));
        core::Box box;
        forEachVertex(sculptor.mesh(), [&](Slot v) { box.extend(sculptor.mesh().point(v).cast<double>()); });
        if (masked) {
            maskAt(sculptor, {box.max().x(), 0, 0}, 0.2);
            change(sculptor, MaskOperation{How::Part});
        }
        const std::set<std::set<Point>> faces = maskedFaces(sculptor.mesh());
        const std::vector<Vec3> path(20, Vec3(box.center().x() - 0.05, 0, 0));
        const std::vector<DabReport> reports = stroke(sculptor, settingsOf(Tool::Pull, 0.3), path);
        QCOMPARE(core::checkMesh(core::extractMesh(sculptor.mesh())).components, masked ? 2 : 1);
        QVERIFY(!masked || std::ranges::any_of(reports, [](const DabReport& report) { return report.contact; }));
        QCOMPARE(maskedFaces(sculptor.mesh()), faces);
        QVERIFY(isSound(sculptor));
    }
}

void TestMask::masked_takesNoColour()
{
    const auto sculptor = ball(4);
    maskAt(*sculptor, onBall(0), 12);
    StrokeSettings paint = settingsOf(Tool::Paint, 25, 0);
    paint.color = {10, 20, 200};
    stroke(*sculptor, paint, {onBall(0)});
    int painted = 0;
    forEachVertex(sculptor->mesh(), [&](Slot v) {
        const bool isBlue = sculptor->mesh().color(v) == paint.color;
        QVERIFY(!isBlue || sculptor->mesh().mask(v) == 0);
        painted += isBlue;
    });
    QVERIFY(painted > 20);
}

void TestMask::split_takesTheMean()
{
    const auto mesh = mesh_asserts::sculptable(core::icosphere(1, 1));
    mesh->beginStroke();
    const Slot a = mesh->to(0), b = mesh->to(1);
    mesh->setMask(a, 255);
    mesh->setMask(b, 100);
    const Slot m = mesh->splitEdge(0, mesh->lattice().snap(0.5 * (mesh->point(a) + mesh->point(b)).cast<double>()));
    QCOMPARE(int(mesh->mask(m)), 178);
    QCOMPARE(mesh->color(m), mesh->color(a));
    core::MeshDelta delta = mesh->endStroke();
    mesh->swap(delta);
    QCOMPARE(std::ranges::max(masks(*mesh)), 0);
    mesh->swap(delta);
    QCOMPARE(int(mesh->mask(m)), 178);
}

void TestMask::stroke_isUndone()
{
    const auto sculptor = ball(4);
    const std::uint64_t before = sculptor->mesh().stateHash();
    sculptor->beginStroke(settingsOf(Tool::Mask, 20));
    core::StrokeSample sample;
    sample.position = onBall(0);
    sculptor->addSample(sample);
    core::MeshDelta delta = sculptor->endStroke();
    QVERIFY(!delta.empty());
    const std::uint64_t masked = sculptor->mesh().stateHash();
    QVERIFY(masked != before);
    sculptor->swap(delta);
    QCOMPARE(sculptor->mesh().stateHash(), before);
    sculptor->swap(delta);
    QCOMPARE(sculptor->mesh().stateHash(), masked);
}

void TestMask::saved_comesBack()
{
    const auto sculptor = ball(4);
    stroke(*sculptor, settingsOf(Tool::Mask, 25), {onBall(0)});
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath(QStringLiteral("masked.glb")).toStdString();
    const core::TriangleMesh surface = core::extractMesh(sculptor->mesh());
    QCOMPARE(surface.masks.size(), surface.points.size());
    core::writeMesh(path, surface);
    const core::TriangleMesh back = core::readMesh(path);
    QCOMPARE(back.masks, surface.masks);
    const core::BuildResult built = core::buildMesh(back);
    QVERIFY(built.mesh);
    std::vector<int> before = masks(sculptor->mesh()), after = masks(*built.mesh);
    std::ranges::sort(before);
    std::ranges::sort(after);
    QCOMPARE(after, before);
}

/// The mask of the kept half is mirrored and replaces the mask of the other half.
void TestMask::symmetrized_isItsOwnImage()
{
    const auto sculptor = ball(4);
    maskAt(*sculptor, onBall(50), 15);
    maskAt(*sculptor, onBall(-20), 10);
    const std::size_t kept =
        std::ranges::count_if(maskedPoints(sculptor->mesh()), [](const Point& p) { return p[0] > 5; });
    change(*sculptor, core::Symmetrize{core::Symmetry::X, core::Half::Positive});
    VERIFY_SYMMETRIC(sculptor->mesh(), core::Symmetry::X);
    const std::set<Point> after = maskedPoints(sculptor->mesh());
    QVERIFY(kept > 20 && std::ranges::count_if(after, [](const Point& p) { return p[0] > 5; }) == std::ptrdiff_t(kept));
    for (const auto& [x, y, z] : after)
        QVERIFY(after.contains({-x, y, z}));
    QVERIFY(isSound(*sculptor));
}

/// Faces above the cut keep their mask, even if the masked area crosses the cut.
void TestMask::flattened_staysMasked()
{
    constexpr float level = -10;
    const auto sculptor = ball(4);
    maskAt(*sculptor, onBall(30), 20);
    const auto isAbove = [](const std::set<Point>& face) {
        return std::ranges::all_of(face, [](const Point& p) { return p[1] > level + 1; });
    };
    std::set<std::set<Point>> above;
    std::ranges::copy_if(maskedFaces(sculptor->mesh()), std::inserter(above, above.end()), isAbove);
    change(*sculptor, core::FlattenBase{level + ballRadius});
    QVERIFY(above.size() > 20 && std::ranges::includes(maskedFaces(sculptor->mesh()), above));
    QVERIFY(std::ranges::none_of(maskedPoints(sculptor->mesh()), [](const Point& p) { return p[1] < level - 0.1f; }));
    QVERIFY(isSound(*sculptor));
}

/// A decimated copy has fewer triangles in masked areas, too. Its mask covers about the same area.
void TestMask::decimated_goesAlong()
{
    const auto sculptor = ball();
    maskAt(*sculptor, onBall(30), 20);
    const core::TriangleMesh few = core::decimate(Mesh(sculptor->mesh()), 4000).mesh;
    QCOMPARE(few.masks.size(), few.points.size());
    QVERIFY(std::ranges::count(few.masks, 255) < std::ptrdiff_t(maskedCount(sculptor->mesh())) / 2);
    for (std::size_t v = 0; v < few.points.size(); ++v) {
        const double away = (few.points[v].cast<double>() - onBall(30)).norm();
        QVERIFY(few.masks[v] > 0 ? away < 24 : away > 16);
    }
}

void TestMask::inverted_twiceIsNothing()
{
    const auto sculptor = ball(4);
    stroke(*sculptor, settingsOf(Tool::Mask, 25), {onBall(0)});
    const std::vector<int> before = masks(sculptor->mesh());
    change(*sculptor, MaskOperation{How::Invert});
    const std::vector<int> inverted = masks(sculptor->mesh());
    for (std::size_t i = 0; i < before.size(); ++i)
        QCOMPARE(inverted[i], 255 - before[i]);
    change(*sculptor, MaskOperation{How::Invert});
    QCOMPARE(masks(sculptor->mesh()), before);
    change(*sculptor, MaskOperation{How::Clear});
    QCOMPARE(std::ranges::max(masks(sculptor->mesh())), 0);
}

void TestMask::blurred_isSofterAndSharpenedHarder()
{
    const auto sculptor = ball(4);
    maskAt(*sculptor, onBall(0), 20);
    const auto between = [&] {
        return std::ranges::count_if(masks(sculptor->mesh()), [](int mask) { return mask > 0 && mask < 255; });
    };
    QCOMPARE(between(), 0);
    const std::size_t masked = maskedCount(sculptor->mesh());
    change(*sculptor, MaskOperation{How::Blur});
    const auto soft = between();
    QVERIFY(soft > 20);
    const auto off = [&] { return std::abs(double(maskedCount(sculptor->mesh())) - double(masked)); };
    QVERIFY2(off() < 0.3 * double(masked), "it neither grows nor shrinks");
    for (int i = 0; i < 4; ++i)
        change(*sculptor, MaskOperation{How::Sharpen});
    QVERIFY(between() < soft / 2);
    QVERIFY(off() < 0.3 * double(masked));
}

void TestMask::grown_holdsAndShrunkIsHeld()
{
    const auto sculptor = ball(4);
    maskAt(*sculptor, onBall(0), 20);
    const std::set<Point> before = maskedPoints(sculptor->mesh());
    change(*sculptor, MaskOperation{How::Grow});
    const std::set<Point> grown = maskedPoints(sculptor->mesh());
    QVERIFY(grown.size() > before.size() && std::ranges::includes(grown, before));
    change(*sculptor, MaskOperation{How::Shrink});
    QVERIFY(std::ranges::includes(maskedPoints(sculptor->mesh()), before));
    change(*sculptor, MaskOperation{How::Shrink});
    const std::set<Point> shrunk = maskedPoints(sculptor->mesh());
    QVERIFY(shrunk.size() < before.size() && std::ranges::includes(before, shrunk));
}

void TestMask::cavity_isWhatIsHollow()
{
    const auto sculptor = ball();
    for (int i = 0; i < 5; ++i)
        stroke(*sculptor, settingsOf(Tool::Push, 12), {onBall(0)});
    change(*sculptor, MaskOperation{How::Cavity});
    const Mesh& mesh = sculptor->mesh();
    QVERIFY(maskedCount(mesh) > 10);
    forEachVertex(mesh, [&](Slot v) {
        const bool isBeside = (mesh.point(v).cast<double>() - onBall(0)).norm() > 20;
        QVERIFY(!isBeside || mesh.mask(v) == 0);
    });
}

void TestMask::color_isWhatIsOfIt()
{
    const auto sculptor = ball(4);
    StrokeSettings paint = settingsOf(Tool::Paint, 25, 0);
    paint.color = {200, 30, 30};
    stroke(*sculptor, paint, {onBall(0)});
    change(*sculptor, MaskOperation{How::Color, {205, 28, 35}});
    const Mesh& mesh = sculptor->mesh();
    forEachVertex(mesh, [&](Slot v) { QCOMPARE(int(mesh.mask(v)), mesh.color(v) == paint.color ? 255 : 0); });
    QVERIFY(maskedCount(mesh) > 10);
}

void TestMask::part_isAllOfIt()
{
    Sculptor sculptor(mesh_asserts::sculptable(clay::twoFingers(0.1)));
    core::Box box;
    forEachVertex(sculptor.mesh(), [&](Slot v) { box.extend(sculptor.mesh().point(v).cast<double>()); });
    maskAt(sculptor, {box.max().x(), 0, 0}, 0.2);
    change(sculptor, MaskOperation{How::Part});
    const Mesh& mesh = sculptor.mesh();
    forEachVertex(mesh, [&](Slot v) { QCOMPARE(int(mesh.mask(v)), mesh.point(v).x() > box.center().x() ? 255 : 0); });
}

/// A mask on one side only makes a mirrored dab asymmetric. With masks on both sides the result is symmetric bit for
/// bit.
void TestMask::symmetric_whereTheMaskIs()
{
    for (const bool both : {true, false}) {
        const auto sculptor = ball();
        StrokeSettings mask = settingsOf(Tool::Mask, 10);
        mask.symmetry = both ? core::Symmetry::X : core::Symmetry::None;
        stroke(*sculptor, mask, {onBall(25)});
        StrokeSettings pull = settingsOf(Tool::Pull, 12);
        pull.symmetry = core::Symmetry::X;
        for (const DabReport& report : stroke(*sculptor, pull, arc(15, 30, 5)))
            QCOMPARE(report.asymmetric, !both);
        QCOMPARE(mirror_asserts::asymmetry(sculptor->mesh(), core::Symmetry::X).empty(), both);
        QVERIFY(isSound(*sculptor));
    }
}

void TestMask::footprint_showsWhatIsFree()
{
    const auto sculptor = ball();
    maskAt(*sculptor, onBall(0), 8);
    StrokeSettings pull = settingsOf(Tool::Pull, 15);
    pull.brush = core::BrushShape::Ray;
    const core::Footprint footprint = sculptor->footprint(pull, onBall(0));
    QVERIFY(footprint.slots.size() > 50);
    for (std::size_t i = 0; i < footprint.slots.size(); ++i)
        QVERIFY(footprint.weights[i] == 1 || sculptor->mesh().mask(footprint.slots[i]) < 255);
    QVERIFY(std::ranges::count_if(footprint.weights, [](int weight) { return weight > 1; }) > 50);
}

FETTLE_TEST(TestMask, QCoreApplication)
#include "tst_mask.moc"
