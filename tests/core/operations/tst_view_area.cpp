// Tests what commands do in areas of the view: mask, hide, split, and cuts of what is in front. Every part is sound by
// CGAL's verdict after every command, and undo restores every bit.

#include "core/area/view_area.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/detached_part.h"
#include "core/operations/model_command.h"
#include "core/parts/part_split.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/environment.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <set>

using namespace core;

class TestViewArea : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void mask_isTheAreas_data();
    void mask_isTheAreas();
    void mask_ofTheFrontIsSeen();
    void mask_ofTheFrontStopsAtShownParts();
    void hide_isUndoneByShowingAll();
    void areasWithoutExtent_areRefused();
    void split_dividesThePart();
    void split_withSymmetryTakesBothSides();
    void split_ofTheFrontTakesTheArm();
    void split_withoutPiecesChangesNothing();
    void front_cutsTheArmOnly();
    void front_takesVoidsAlong();
    void front_outsideIsSeenFirst();
    void front_ofAChainIsTheNearest();
    void front_isSymmetric();
    void frontSplit_ofTangledCurvesIsSymmetric();
    void randomAreas_leaveSoundParts();
};

namespace
{
using std::numbers::pi;
using Curve = std::vector<Eigen::Vector2d>;

std::unique_ptr<Mesh> document(const std::vector<TriangleMesh>& solids)
{
    std::vector<PartPiece> pieces;
    for (const TriangleMesh& solid : solids)
        pieces.push_back({static_cast<PartId>(pieces.size()), solid, {}, {}});
    return buildMesh(joined(pieces)).mesh;
}

TriangleMesh ballAt(const Vec3f& centre, double radius, int level = 3)
{
    return shapes::moved(icosphere(level, radius), centre);
}

/// The area of a curve in the plane z = 0, seen from far up the z axis or from an eye there.
ViewArea areaOf(const Curve& curve, std::optional<double> eyeHeight = {})
{
    ViewArea area;
    for (const Eigen::Vector2d& p : curve)
        area.outline.emplace_back(p.x(), p.y(), 0);
    if (eyeHeight)
        area.eye = Vec3(0, 0, *eyeHeight);
    return area;
}

Curve circle(double radius, const Eigen::Vector2d& center = {0, 0}, std::size_t corners = 60)
{
    Curve curve;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * pi * double(i) / double(corners);
        curve.emplace_back(center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    return curve;
}

Curve box(double left, double bottom, double right, double top)
{
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

/// Returns the first defect of a part, or an empty text.
std::string unsoundness(const Mesh& mesh)
{
    const std::string links = mesh_asserts::brokenLinks(mesh);
    if (!links.empty())
        return links;
    for (const PartPiece& piece : splitByPart(extractMesh(mesh))) {
        if (!checkMesh(piece.mesh).printReady() || !judgedByCgal(piece.mesh).value_or(CgalVerdict()).allWell())
            return "part " + std::to_string(piece.part) + " is not sound";
    }
    return {};
}

double volumeOf(const Mesh& mesh, PartId part)
{
    return checkMesh(surfaceOf(mesh, part)).volume.value_or(0);
}

/// Applies the command, and checks that undo and redo restore every bit.
ModelChange applied(Mesh& mesh, const ModelCommand& command, PartId part = 0)
{
    ModelChange change = applyToCopy(mesh, command, {}, part);
    if (!change.changes)
        return change;
    const std::uint64_t before = mesh.stateHash();
    mesh.swap(change.delta);
    const std::uint64_t after = mesh.stateHash();
    mesh.swap(change.delta);
    if (mesh.stateHash() != before)
        qFatal("undo is no identity");
    mesh.swap(change.delta);
    if (mesh.stateHash() != after)
        qFatal("redo is no identity");
    if (const std::string defect = unsoundness(mesh); !defect.empty())
        qFatal("%s", defect.c_str());
    return change;
}

std::set<std::array<int, 3>> placesOf(const Mesh& mesh, PartId part)
{
    std::set<std::array<int, 3>> places;
    for (const Slot v : mesh.vertices()) {
        const LatticePoint p = mesh.latticePoint(v);
        if (mesh.part(v) == part)
            places.insert({p.x(), p.y(), p.z()});
    }
    return places;
}
} // namespace

void TestViewArea::mask_isTheAreas_data()
{
    QTest::addColumn<bool>("isPerspective");
    QTest::addColumn<bool>("isOutside");
    QTest::addColumn<bool>("isSymmetric");
    for (const bool isPerspective : {false, true})
        for (const bool isOutside : {false, true})
            for (const bool isSymmetric : {false, true})
                QTest::addRow("%d%d%d", isPerspective, isOutside, isSymmetric)
                    << isPerspective << isOutside << isSymmetric;
}

/// Compares with the circle itself: only vertices that are seen near the curve may differ.
void TestViewArea::mask_isTheAreas()
{
    QFETCH(const bool, isPerspective);
    QFETCH(const bool, isOutside);
    QFETCH(const bool, isSymmetric);
    constexpr double radius = 0.4, height = 4;
    const Eigen::Vector2d center(0.35, 0.1);
    const auto mesh = document({icosphere(4, 1)});
    ViewArea area =
        areaOf(circle(radius, center, ViewArea::maxCorners), isPerspective ? std::optional(height) : std::nullopt);
    area.side = isOutside ? ViewArea::Side::Outside : ViewArea::Side::Inside;
    area.symmetry = isSymmetric ? Symmetry::X : Symmetry::None;
    QVERIFY(applied(*mesh, MaskArea{area}).changes);
    const auto distance = [&](Vec3 p, bool isImage) {
        p.x() *= isImage ? -1 : 1;
        const double share = isPerspective ? height / (height - p.z()) : 1;
        return (Eigen::Vector2d(p.head<2>() * share) - center).norm() - radius;
    };
    int masked = 0;
    for (const Slot v : mesh->vertices()) {
        const Vec3 p = mesh->point(v).cast<double>();
        const double away = isSymmetric ? std::min(distance(p, false), distance(p, true)) : distance(p, false);
        if (std::abs(away) < 1e-4)
            continue;
        QCOMPARE(mesh->mask(v), (away < 0) != isOutside ? 255 : 0);
        masked += mesh->mask(v) > 0;
    }
    QVERIFY(masked > 100);
    QVERIFY(applied(*mesh, MaskArea{area, true}).changes);
    for (const Slot v : mesh->vertices())
        QCOMPARE(mesh->mask(v), 0);
    QVERIFY(!applyToCopy(*mesh, MaskArea{area, true}).changes);
}

/// On a ball, what faces the eye is seen; in a torus, the near side of the tube hides the far one.
void TestViewArea::mask_ofTheFrontIsSeen()
{
    const auto ball = document({icosphere(4, 1)});
    ViewArea area = areaOf(circle(0.5));
    area.isFrontOnly = true;
    QVERIFY(applied(*ball, MaskArea{area}).changes);
    for (const Slot v : ball->vertices()) {
        const Vec3f& p = ball->point(v);
        if (std::abs(p.head<2>().norm() - 0.5F) > 0.01F)
            QCOMPARE(ball->mask(v), p.head<2>().norm() < 0.5F && p.z() > 0 ? 255 : 0);
    }
    const auto torus = document({shapes::torus({3, 1, 96, 48})}); // its axis is z or another one: look along y
    ViewArea side;
    side.direction = -Vec3::UnitY();
    side.outline = {{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}};
    side.isFrontOnly = true;
    QVERIFY(applied(*torus, MaskArea{side}).changes);
    int masked = 0;
    for (const Slot v : torus->vertices()) {
        masked += torus->mask(v) > 0;
        if (torus->mask(v) > 0)
            QVERIFY(torus->point(v).y() > -1.2F);
    }
    QVERIFY(masked > 400);
}

/// Another part hides what is behind it, until it is hidden itself.
void TestViewArea::mask_ofTheFrontStopsAtShownParts()
{
    const auto mesh = document({ballAt({0, 0, 0}, 1), ballAt({0, 0, 3}, 1.5)});
    ViewArea area = areaOf(circle(0.6));
    area.isFrontOnly = true;
    QVERIFY(!applyToCopy(*mesh, MaskArea{area}, {}, 0).changes);
    QVERIFY(applied(*mesh, ShowParts{{0}}).changes);
    QVERIFY(applied(*mesh, MaskArea{area}, 0).changes);
    for (const Slot v : mesh->vertices())
        QVERIFY(mesh->mask(v) == 0 || (mesh->part(v) == 0 && mesh->point(v).z() > 0));
}

void TestViewArea::hide_isUndoneByShowingAll()
{
    const auto mesh = document({icosphere(4, 1), ballAt({0, 0, 3}, 1)});
    ViewArea area = areaOf(circle(0.5), 9.0);
    QVERIFY(applied(*mesh, HideArea{area}, 0).changes);
    QVERIFY(!applyToCopy(*mesh, HideArea{area}, {}, 0).changes);
    int hidden = 0;
    for (const Slot v : mesh->vertices()) {
        hidden += mesh->isHidden(v);
        QVERIFY(!mesh->isHidden(v) || (mesh->part(v) == 0 && mesh->point(v).head<2>().norm() < 0.6F));
    }
    QVERIFY(hidden > 50);
    // hidden clay keeps its mask
    QVERIFY(!applyToCopy(*mesh, MaskArea{areaOf(circle(0.3), 9.0)}, {}, 0).changes);
    QVERIFY(applied(*mesh, Hide{Hide::What::Nothing}).changes);
    for (const Slot v : mesh->vertices())
        QVERIFY(!mesh->isHidden(v));
}

void TestViewArea::areasWithoutExtent_areRefused()
{
    const auto mesh = document({icosphere(3, 1)});
    for (const Curve& curve : {Curve(), Curve{{0, 0}}, Curve{{0, 0}, {1, 1}}, Curve{{0, 0}, {1, 1}, {2, 2}},
                               Curve{{0, 0}, {1, 0}, {0, std::nan("")}}}) {
        for (const auto& eye : {std::optional<double>(), std::optional<double>(4)}) {
            const ViewArea area = areaOf(curve, eye);
            for (const ModelCommand& command : {ModelCommand(Trim{area}), ModelCommand(MaskArea{area}),
                                                ModelCommand(HideArea{area}), ModelCommand(SplitPart{area, "new"})})
                QVERIFY(applyToCopy(*mesh, command).refusal == ModelRefusal::NoOutline);
        }
    }
}

/// Both parts are sound, their volumes make up the whole, and nearly all vertices of one cut are those of the other.
void TestViewArea::split_dividesThePart()
{
    const auto seed = numberFromEnvironment("FETTLE_SEED", 1);
    StrokeFuzzer random(seed);
    for (int i = 0; i < byEffort(15, 150); ++i) {
        const auto mesh = document({i % 3 == 0 ? clay::bowl() : icosphere(4, 1), ballAt({0, 0, 6}, 1)});
        const auto before = placesOf(*mesh, 0);
        const double whole = volumeOf(*mesh, 0);
        ViewArea area = areaOf(circle(random.uniform(0.2, 0.8), {random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4)}),
                               random.below(2) ? std::optional<double>(5) : std::nullopt);
        area.side = random.below(2) ? ViewArea::Side::Inside : ViewArea::Side::Outside;
        const ModelChange change = applied(*mesh, SplitPart{area, "Arm"});
        const QString where = QStringLiteral("seed %1, split %2").arg(seed).arg(i);
        QVERIFY2(change.changes, qPrintable(where));
        const Part* added = mesh->frame().parts.find(2);
        QVERIFY(added && added->name == "Arm" && mesh->frame().parts.size() == 3);
        QVERIFY2(std::abs(volumeOf(*mesh, 0) + volumeOf(*mesh, 2) - whole) < 1e-5 * whole, qPrintable(where));
        const auto kept = placesOf(*mesh, 0), taken = placesOf(*mesh, 2);
        int onBoth = 0, apart = 0; // a few points may be rounded otherwise
        for (const auto& place : taken) {
            onBoth += kept.contains(place);
            apart += !before.contains(place) && !kept.contains(place);
        }
        QVERIFY2(onBoth > 20 && apart < onBoth / 50 + 2,
                 qPrintable(where + QStringLiteral(": %1, %2").arg(onBoth).arg(apart)));
    }
}

void TestViewArea::split_withSymmetryTakesBothSides()
{
    const auto mesh = document({icosphere(4, 1)});
    QVERIFY(applyToCopy(*mesh, Symmetrize{Symmetry::X, Half::Positive}).refusal == ModelRefusal::None);
    applied(*mesh, Symmetrize{Symmetry::X, Half::Positive});
    ViewArea area = areaOf(circle(0.25, {0.6, 0}));
    area.symmetry = Symmetry::X;
    QVERIFY(applied(*mesh, SplitPart{area, "Ears"}).changes);
    QCOMPARE(mesh->frame().parts.size(), std::size_t(2));
    for (const PartId part : {PartId(0), PartId(1)})
        VERIFY_SYMMETRIC(*buildMesh(surfaceOf(*mesh, part)).mesh, Symmetry::X);
    QCOMPARE(checkMesh(surfaceOf(*mesh, 1)).components, std::size_t(2));
}

void TestViewArea::split_ofTheFrontTakesTheArm()
{
    const auto mesh = document({shapes::together(ballAt({0, 0, 0}, 1), ballAt({0, 0, 3}, 0.5))});
    const double whole = volumeOf(*mesh, 0);
    ViewArea area = areaOf(box(0, -2, 2, 2));
    area.isFrontOnly = true;
    QVERIFY(applied(*mesh, SplitPart{area, "Half an arm"}).changes);
    for (const Slot v : mesh->vertices())
        QVERIFY(mesh->part(v) == 0 || mesh->point(v).z() > 2);
    QVERIFY(std::abs(volumeOf(*mesh, 0) + volumeOf(*mesh, 1) - whole) < 1e-5 * whole);
    // the whole arm, although the curve is around all
    ViewArea all = areaOf(circle(5));
    all.isFrontOnly = true;
    const auto fresh = document({shapes::together(ballAt({0, 0, 0}, 1), ballAt({0, 0, 3}, 0.5))});
    QVERIFY(applied(*fresh, SplitPart{all, "Arm"}).changes);
    for (const Slot v : fresh->vertices())
        QCOMPARE(fresh->part(v) == 1, fresh->point(v).z() > 2);
}

void TestViewArea::split_withoutPiecesChangesNothing()
{
    const auto mesh = document({icosphere(3, 1)});
    for (const Curve& curve : {circle(3), circle(0.3, {5, 0})}) {
        for (const auto side : {ViewArea::Side::Inside, ViewArea::Side::Outside}) {
            ViewArea area = areaOf(curve);
            area.side = side;
            const ModelChange change = applyToCopy(*mesh, SplitPart{area, "new"});
            QVERIFY(!change.changes && change.refusal == ModelRefusal::None);
        }
    }
}

/// The curve is wider than the arm, so the body is seen beside it, and stays bit for bit.
void TestViewArea::front_cutsTheArmOnly()
{
    const TriangleMesh body = icosphere(4, 2), arm = ballAt({0, 0, 4}, 0.7);
    for (const auto& eye : {std::optional<double>(), std::optional<double>(9)}) {
        const auto mesh = document({shapes::together(body, arm)});
        const auto bodyOf = [](const Mesh& whole) {
            std::multiset<std::array<float, 3>> corners;
            for (const Slot f : whole.faces())
                for (const Slot v : whole.corners(f))
                    if (const Vec3f& p = whole.point(v); p.z() < 2.5F)
                        corners.insert({p.x(), p.y(), p.z()});
            return corners;
        };
        const auto before = bodyOf(*mesh);
        ViewArea area = areaOf(box(-1.9, -0.2, 1.9, 3), eye);
        area.isFrontOnly = true;
        QVERIFY(applied(*mesh, Trim{area}).changes);
        QCOMPARE(checkMesh(extractMesh(*mesh)).components, std::size_t(2));
        QVERIFY(bodyOf(*mesh) == before);
        for (const Slot v : mesh->vertices())
            QVERIFY(mesh->point(v).z() < 2.5F || mesh->point(v).y() < 0.1F);
    }
}

/// A hollow ball before a ball goes with its void.
void TestViewArea::front_takesVoidsAlong()
{
    const auto mesh =
        document({shapes::together(shapes::moved(shapes::nestedSpheres(true), {0, 0, 5}), ballAt({0, 0, -5}, 1))});
    ViewArea area = areaOf(circle(9));
    area.isFrontOnly = true;
    QVERIFY(applied(*mesh, Trim{area}).changes);
    QCOMPARE(checkMesh(extractMesh(*mesh)).components, std::size_t(1));
    for (const Slot v : mesh->vertices())
        QVERIFY(mesh->point(v).z() < 0);
    QVERIFY(applyToCopy(*mesh, Trim{area}).refusal == ModelRefusal::NothingLeft);
}

void TestViewArea::front_outsideIsSeenFirst()
{
    const auto mesh = document({shapes::together(ballAt({0, 0, 4}, 1), ballAt({0, 0, -4}, 2))});
    ViewArea area = areaOf(circle(0.5));
    area.side = ViewArea::Side::Outside;
    area.isFrontOnly = true;
    const double whole = volumeOf(*mesh, 0);
    QVERIFY(applied(*mesh, Trim{area}).changes); // leaves a rod of the near ball
    QVERIFY(whole - volumeOf(*mesh, 0) > 2 && whole - volumeOf(*mesh, 0) < 4);
    for (const Slot v : mesh->vertices())
        QVERIFY(mesh->point(v).z() < 0 || mesh->point(v).head<2>().norm() < 0.51F);
}

/// Two links of a chain, each over the other: none is seen first, so the one that comes nearer goes.
void TestViewArea::front_ofAChainIsTheNearest()
{
    const TriangleMesh level = shapes::torus({3, 0.5, 48, 16}); // around the y axis
    TriangleMesh upright = level;
    for (Vec3f& p : upright.points)
        p = Vec3f(p.z() + 3, p.x(), p.y());
    const auto mesh = document({shapes::together(level, upright)});
    ViewArea area;
    area.direction = -Vec3::UnitY();
    area.outline = {{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}};
    area.isFrontOnly = true;
    QVERIFY(applied(*mesh, Trim{area}).changes);
    QCOMPARE(checkMesh(extractMesh(*mesh)).components, std::size_t(1));
    for (const Slot v : mesh->vertices())
        QVERIFY(std::abs(mesh->point(v).y()) < 0.6F);
}

void TestViewArea::front_isSymmetric()
{
    for (const double at : {0.2, 0.6}) { // with and without overlap of the two curves
        const auto mesh = document({shapes::together(icosphere(4, 2), ballAt({0, 0, 4}, 1))});
        applied(*mesh, Symmetrize{Symmetry::X, Half::Positive});
        ViewArea area = areaOf(circle(0.35, {at, 0}), 12.0);
        area.isFrontOnly = true;
        area.symmetry = Symmetry::X;
        QVERIFY(applied(*mesh, Trim{area}).changes);
        VERIFY_SYMMETRIC(*mesh, Symmetry::X);
        QCOMPARE(checkMesh(extractMesh(*mesh)).genus.value_or(-1), at < 0.35 ? 1 : 2);
    }
}

/// Splits what is in front along curves that cross themselves and their images. Both parts are sound, symmetric bit for
/// bit, and add up.
void TestViewArea::frontSplit_ofTangledCurvesIsSymmetric()
{
    int done = 0;
    const std::uint64_t first = numberFromEnvironment("FETTLE_SEED", 500), count = byEffort(12u, 200u);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const std::string where = "seed " + std::to_string(seed);
        StrokeFuzzer random(seed);
        const std::array<TriangleMesh, 4> shapes{shapes::together(icosphere(3, 2), ballAt({0, 0, 4}, 1)), clay::bowl(),
                                                 shapes::torus({1.5, 0.4, 48, 16}), icosphere(3, 2)};
        const auto mesh = document({shapes[seed % 4]});
        applied(*mesh, Symmetrize{Symmetry::X, Half::Positive});
        Curve curve;
        for (auto corners = 4 + random.below(8); corners > 0; --corners) {
            const double x = random.uniform(-2, 2), y = random.uniform(-2, 2);
            curve.emplace_back(x, y);
        }
        ViewArea area = areaOf(curve, seed % 2 ? std::optional(12.0) : std::nullopt);
        area.isFrontOnly = true;
        area.symmetry = seed % 3 ? Symmetry::X : Symmetry::None;
        const double whole = volumeOf(*mesh, 0);
        const ModelChange change = applied(*mesh, SplitPart{area, "front"});
        QVERIFY2(change.refusal == ModelRefusal::None, where.c_str());
        if (!change.changes)
            continue;
        ++done;
        for (const PartId part : {PartId(0), PartId(1)}) {
            const std::string asymmetry =
                mirror_asserts::asymmetry(*buildMesh(surfaceOf(*mesh, part)).mesh, Symmetry::X);
            QVERIFY2(area.symmetry == Symmetry::None || asymmetry.empty(), (where + ": " + asymmetry).c_str());
        }
        QVERIFY2(std::abs(volumeOf(*mesh, 0) + volumeOf(*mesh, 1) - whole) < 1e-4 * whole, where.c_str());
    }
    QVERIFY2(done > static_cast<int>(count) / 2, qPrintable(QString::number(done)));
}

namespace
{
Curve randomCurve(StrokeFuzzer& random)
{
    const auto number = [&](double reach) { return random.uniform(-reach, reach); };
    Curve curve;
    switch (random.below(6)) {
    case 0: // crosses itself
        for (auto corners = 4 + random.below(20); corners > 0; --corners)
            curve.emplace_back(number(2), number(2));
        return curve;
    case 1: // tiny
        return circle(random.uniform(1e-6, 1e-2), {number(1), number(1)}, 3 + random.below(20));
    case 2: // off the model
        return circle(random.uniform(0.1, 1), {8 + number(1), number(1)});
    case 3: // of many corners
        for (int i = 0; i < 800; ++i) {
            const double angle = 2 * pi * i / 800;
            curve.emplace_back((1 + 0.1 * std::sin(40 * angle)) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        }
        return curve;
    case 4: { // a half plane, as a line gives
        const Eigen::Vector2d at(number(1), number(1)), way = Eigen::Vector2d(number(1), number(1)).normalized(),
                                                        aside(way.y(), -way.x());
        return {at - 50 * way, at + 50 * way, at + 50 * (way + aside), at + 50 * (aside - way)};
    }
    default:
        return box(number(1) - 1, number(1) - 1, number(1) + 1, number(1) + 1);
    }
}

ViewArea randomArea(StrokeFuzzer& random)
{
    const Vec3 along = random.direction(), right = along.unitOrthogonal(), up = right.cross(along);
    ViewArea area;
    area.direction = random.uniform(0.1, 9) * along;
    for (const Eigen::Vector2d& p : randomCurve(random))
        area.outline.push_back(p.x() * right + p.y() * up);
    if (random.below(2) == 0)
        area.eye = -random.uniform(-1, 12) * along + 0.1 * random.direction(); // now and then beyond the curve
    area.side = random.below(3) == 0 ? ViewArea::Side::Outside : ViewArea::Side::Inside;
    area.isFrontOnly = random.below(2) == 0;
    area.symmetry = static_cast<Symmetry>(random.below(4));
    return area;
}
} // namespace

/// Random commands one after the other on the parts that they leave. FETTLE_SEED chooses others.
void TestViewArea::randomAreas_leaveSoundParts()
{
    const auto seed = numberFromEnvironment("FETTLE_SEED", 1);
    int changes = 0, refusals = 0;
    for (int round = 0; round < byEffort(5, 200); ++round) {
        StrokeFuzzer random(seed * 1000 + static_cast<std::uint64_t>(round));
        const TriangleMesh starts[] = {icosphere(3, 1), shapes::torus({1, 0.4, 40, 20}), clay::spiral(),
                                       shapes::nestedSpheres(true),
                                       shapes::together(ballAt({0, 0, 0}, 1), ballAt({0, 0, 2.5}, 0.7))};
        const auto mesh =
            document({starts[static_cast<std::size_t>(round) % std::size(starts)], ballAt({0.5F, 0.3F, 1}, 1, 2)});
        for (int i = 0; i < 6; ++i) {
            const ViewArea area = randomArea(random);
            const ModelCommand commands[] = {Trim{area}, Trim{area, Rgb{9, 9, 9}}, SplitPart{area, "new"},
                                             MaskArea{area, random.below(3) == 0}, HideArea{area}};
            const auto& parts = mesh->frame().parts.all();
            const PartId part = parts[random.below(parts.size())].id;
            const auto kind = random.below(std::size(commands));
            qInfo("seed %llu, round %d, command %d: kind %d", static_cast<unsigned long long>(seed), round, i,
                  static_cast<int>(kind));
            const double before = volumeOf(*mesh, part);
            const std::size_t count = parts.size();
            const ModelChange change = applied(*mesh, commands[kind], part);
            changes += change.changes;
            refusals += change.refusal == ModelRefusal::NoCut;
            if (mesh->frame().parts.size() > count) {
                const double sum = volumeOf(*mesh, part) + volumeOf(*mesh, mesh->frame().parts.find(part)[1].id);
                QVERIFY2(std::abs(sum - before) < 1e-4 * before, qPrintable(QString::number(sum / before)));
            }
        }
    }
    QVERIFY2(changes > 2 * byEffort(5, 200), qPrintable(QString::number(changes)));
    QVERIFY2(refusals < changes / 10, qPrintable(QString::number(refusals)));
}

FETTLE_TEST(TestViewArea, QCoreApplication)

#include "tst_view_area.moc"
