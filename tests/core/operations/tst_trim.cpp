// Tests cuts along curves: both parts are sound by CGAL's verdict, their volumes add up, and the cut is on the curve.

#include "core/area/winding_outline.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/detached_part.h"
#include "core/operations/model_command.h"
#include "core/operations/plane_cut.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/environment.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace core;
using mesh_asserts::sculptable;
using mesh_asserts::volumeOf;

class TestTrim : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lassos_divideTheModel_data();
    void lassos_divideTheModel();
    void tangledLassos_divideTheModel();
    void line_halvesABall();
    void loopsOfAnEight_areBothInside();
    void innerTurn_isInside();
    void ring_leavesItsHole();
    void symmetricModel_remainsSymmetric_data();
    void symmetricModel_remainsSymmetric();
    void curveBeside_changesNothing();
    void everything_isNotCutAway();
    void badCurves_areRefused();
    void eyeWithinTheModel_cutsWhatIsBefore();
    void colorsAndMasks_areKept();
    void cutFaces_areAsFineAsTheModel();
    void stopped_changesNothing();
    void plane_cutsFlat();
    void symmetricPlanes_keepTheSymmetry_data();
    void symmetricPlanes_keepTheSymmetry();
    void ownImage_isCutOnce();
    void planeOfSymmetry_halves();
    void imagesTogether_mayLeaveNothing();
    void modelBesideThePlaneOfSymmetry_isCutByTheImage();
    void symmetricSplit_isOnePart();
};

namespace
{
using std::numbers::pi;

/// A view of a model of about one unit: perspective from an eye, or parallel.
struct View
{
    Vec3 eye, along, right, up;
    bool isPerspective;

    /// Returns a point of the plane through the origin that faces the view.
    Vec3 at(double x, double y) const { return right * x + up * y; }
    /// Returns where the line of sight through p meets that plane.
    Eigen::Vector2d seen(const Vec3& p) const
    {
        const Vec3 on = isPerspective ? Vec3(eye + (p - eye) * (eye.dot(along) / (eye - p).dot(along))) : p;
        return {right.dot(on), up.dot(on)};
    }
};

View randomView(StrokeFuzzer& random, double distance)
{
    const auto signedUnit = [&] { return random.uniform(-1, 1); };
    const Vec3 along = Vec3(signedUnit(), signedUnit(), signedUnit() + 0.01).normalized();
    const Vec3 right = along.unitOrthogonal();
    return {-distance * along, along, right, right.cross(along), random.below(2) == 0};
}

Trim trimOf(const View& view, const std::vector<Eigen::Vector2d>& curve)
{
    Trim trim;
    for (const Eigen::Vector2d& p : curve)
        trim.area.outline.push_back(view.at(p.x(), p.y()));
    trim.area.direction = 3 * view.along;
    if (view.isPerspective)
        trim.area.eye = view.eye;
    return trim;
}

/// Returns a curve that does not cross itself: a star around a point.
std::vector<Eigen::Vector2d> randomStar(StrokeFuzzer& random, double size)
{
    const Eigen::Vector2d center(random.uniform(-size, size), random.uniform(-size, size));
    const int corners = 3 + static_cast<int>(random.below(60));
    const double radius = random.uniform(0.2, 1.2) * size, waves = 2 + static_cast<double>(random.below(5));
    std::vector<Eigen::Vector2d> curve;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * i / corners;
        const double reach = radius * (1 + 0.4 * std::sin(waves * angle) + random.uniform(-0.1, 0.1));
        curve.emplace_back(center + reach * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    if (random.below(2) == 0)
        std::ranges::reverse(curve);
    return curve;
}

std::vector<Eigen::Vector2d> circle(double radius, int corners, const Eigen::Vector2d& center = {0, 0})
{
    std::vector<Eigen::Vector2d> curve;
    for (int i = 0; i < corners; ++i)
        curve.emplace_back(center +
                           radius * Eigen::Vector2d(std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners)));
    return curve;
}

double distanceTo(const std::vector<Eigen::Vector2d>& curve, const Eigen::Vector2d& p)
{
    double least = 1e300;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Eigen::Vector2d a = curve[i], way = curve[(i + 1) % curve.size()] - a;
        const double share = std::clamp((p - a).dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
        least = std::min(least, (p - a - share * way).norm());
    }
    return least;
}

std::set<std::array<int, 3>> placesOf(const Mesh& mesh)
{
    std::set<std::array<int, 3>> places;
    for (const Slot v : mesh.vertices()) {
        const LatticePoint p = mesh.latticePoint(v);
        places.insert({p.x(), p.y(), p.z()});
    }
    return places;
}

/// Returns whether one of the places is at most two units away in each coordinate.
bool isNear(const std::set<std::array<int, 3>>& places, const LatticePoint& p)
{
    for (int x = p.x() - 2; x <= p.x() + 2; ++x)
        for (int y = p.y() - 2; y <= p.y() + 2; ++y)
            for (int z = p.z() - 2; z <= p.z() + 2; ++z)
                if (places.contains({x, y, z}))
                    return true;
    return false;
}

const View frontView{{0, 0, 10}, -Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY(), false};

/// Applies the command, checks the result, and returns its volume; 0 if nothing would be left, -1 if it is unsound.
double volumeAfter(Mesh& mesh, const Trim& trim, const View& view, const std::vector<Eigen::Vector2d>& curve,
                   double tolerance, QString& fault)
{
    const auto before = placesOf(mesh);
    const std::uint64_t hash = mesh.stateHash();
    ModelChange change = applyToCopy(mesh, trim);
    if (change.refusal == ModelRefusal::NothingLeft)
        return 0;
    if (change.refusal != ModelRefusal::None) {
        fault = QStringLiteral("refused: %1").arg(static_cast<int>(change.refusal));
        return -1;
    }
    if (!change.changes)
        return volumeOf(mesh);
    mesh.swap(change.delta);
    fault = QString::fromStdString(mesh_asserts::unsoundness(mesh));
    for (const Slot v : mesh.vertices()) {
        const LatticePoint p = mesh.latticePoint(v);
        const double away = distanceTo(curve, view.seen(mesh.point(v).cast<double>()));
        if (!isNear(before, p) && away > tolerance * mesh.lattice().unit())
            fault = QStringLiteral("a new vertex is %1 units from the curve").arg(away / mesh.lattice().unit());
    }
    const double volume = volumeOf(mesh);
    mesh.swap(change.delta);
    if (mesh.stateHash() != hash)
        fault = QStringLiteral("undo is no identity");
    return volume;
}

/// Checks that the parts inside and outside a curve are sound and make up the whole. Returns a fault, or an empty text.
QString faultOfParts(const TriangleMesh& shape, const View& view, const std::vector<Eigen::Vector2d>& curve,
                     double tolerance)
{
    const auto mesh = sculptable(shape);
    const double whole = volumeOf(*mesh);
    Trim trim = trimOf(view, curve);
    QString fault;
    const double without = volumeAfter(*mesh, trim, view, curve, tolerance, fault);
    trim.area.side = ViewArea::Side::Outside;
    const double within = volumeAfter(*mesh, trim, view, curve, tolerance, fault);
    const double error = std::abs(without + within - whole);
    // rounding moves the surface by at most half a unit of a lattice that may be four times coarser than the mesh's
    const double area = checkMesh(extractMesh(*mesh)).area;
    if (fault.isEmpty() && error > 1e-5 * whole + 4 * mesh->lattice().unit() * area)
        fault = QStringLiteral("volumes %1 and %2 are not %3").arg(without).arg(within).arg(whole);
    return fault;
}

Box boxAround(const Mesh& mesh)
{
    Box box;
    for (const Slot v : mesh.vertices())
        box.extend(mesh.point(v).cast<double>());
    return box;
}

/// Checks a cut that must succeed, makes it, and returns the volume that it removed.
double removedBy(Mesh& mesh, const Trim& trim)
{
    const double before = volumeOf(mesh);
    ModelChange change = applyToCopy(mesh, trim);
    if (change.refusal != ModelRefusal::None)
        return -1;
    mesh.swap(change.delta);
    return mesh_asserts::unsoundness(mesh).empty() ? before - volumeOf(mesh) : -2;
}
} // namespace

void TestTrim::lassos_divideTheModel_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::addColumn<double>("size");
    QTest::addRow("ball") << icosphere(4, 1) << 1.0;
    QTest::addRow("cube") << shapes::cube(1) << 0.7;
    QTest::addRow("torus") << shapes::torus() << 4.0;
    QTest::addRow("shell") << shapes::nestedSpheres(true) << 1.0;
    QTest::addRow("bowl") << clay::bowl() << 1.0;
    QTest::addRow("thin slab") << clay::slab(2, 0.02, 12) << 1.0;
    QTest::addRow("spiral") << clay::spiral() << 1.0;
    QTest::addRow("parts") << shapes::together(icosphere(2, 1), shapes::moved(icosphere(3, 1), {3, 0, 0})) << 2.0;
}

void TestTrim::lassos_divideTheModel()
{
    QFETCH(const TriangleMesh, shape);
    QFETCH(const double, size);
    StrokeFuzzer random(20261128);
    for (int i = 0; i < byEffort(12, 120); ++i) {
        const View view = randomView(random, 4 * size);
        const QString fault = faultOfParts(shape, view, randomStar(random, size), 12);
        QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("lasso %1: %2").arg(i).arg(fault)));
    }
}

/// Curves that cross themselves many times. Where they do, the cut is drawn back by a little more.
void TestTrim::tangledLassos_divideTheModel()
{
    StrokeFuzzer random(7);
    for (int i = 0; i < byEffort(25, 400); ++i) {
        const View view = randomView(random, 5);
        std::vector<Eigen::Vector2d> curve;
        for (int corners = 4 + static_cast<int>(random.below(20)); corners > 0; --corners)
            curve.emplace_back(random.uniform(-1.3, 1.3), random.uniform(-1.3, 1.3));
        const QString fault = faultOfParts(icosphere(3, 1), view, curve, 200);
        QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("lasso %1: %2").arg(i).arg(fault)));
    }
}

/// A line is a half plane far beyond the model.
void TestTrim::line_halvesABall()
{
    const auto mesh = sculptable(icosphere(4, 1));
    const double whole = volumeOf(*mesh);
    const double removed = removedBy(*mesh, trimOf(frontView, {{-500, 0}, {500, 0}, {500, 900}, {-500, 900}}));
    QVERIFY(std::abs(removed / whole - 0.5) < 1e-5);
    for (const Slot v : mesh->vertices())
        QVERIFY(mesh->point(v).y() <= static_cast<float>(2 * mesh->lattice().unit()));
}

void TestTrim::loopsOfAnEight_areBothInside()
{
    const auto mesh = sculptable(shapes::cube(2));
    QVERIFY(std::abs(removedBy(*mesh, trimOf(frontView, {{-0.5, -0.5}, {0.5, 0.5}, {0.5, -0.5}, {-0.5, 0.5}})) - 1) <
            1e-3);
}

/// A part that the curve goes around twice is inside as well.
void TestTrim::innerTurn_isInside()
{
    const auto mesh = sculptable(shapes::cube(2));
    std::vector<Eigen::Vector2d> curve = circle(0.8, 90), inner = circle(0.4, 90, {0.4, 0});
    curve.insert(curve.end(), inner.begin(), inner.end());
    const double disc = 45 * 0.8 * 0.8 * std::sin(2 * pi / 90);
    QVERIFY(std::abs(removedBy(*mesh, trimOf(frontView, curve)) / (2 * disc) - 1) < 1e-3);
}

/// A curve that runs around, across to a hole, around it the other way and back has the hole outside.
void TestTrim::ring_leavesItsHole()
{
    const auto mesh = sculptable(shapes::cube(2));
    std::vector<Eigen::Vector2d> curve = circle(0.8, 90), inner = circle(0.4, 90);
    curve.push_back(curve.front());
    inner.push_back(inner.front());
    curve.insert(curve.end(), inner.rbegin(), inner.rend());
    const double ring = 45 * (0.64 - 0.16) * std::sin(2 * pi / 90);
    QVERIFY(std::abs(removedBy(*mesh, trimOf(frontView, curve)) / (2 * ring) - 1) < 1e-3);
    QCOMPARE(checkMesh(extractMesh(*mesh)).components, std::size_t(2));
}

void TestTrim::symmetricModel_remainsSymmetric_data()
{
    QTest::addColumn<Symmetry>("plane");
    QTest::addRow("x") << Symmetry::X;
    QTest::addRow("y") << Symmetry::Y;
    QTest::addRow("z") << Symmetry::Z;
}

void TestTrim::symmetricModel_remainsSymmetric()
{
    QFETCH(const Symmetry, plane);
    StrokeFuzzer random(5);
    int done = 0;
    const int rounds = byEffort(16, 200);
    for (int i = 0; i < rounds; ++i) {
        const auto mesh = sculptable(i % 2 ? icosphere(3, 1) : clay::bowl());
        ModelChange change = applyToCopy(*mesh, Symmetrize{plane, Half::Positive});
        QVERIFY(change.refusal == ModelRefusal::None);
        mesh->swap(change.delta);
        Trim trim = trimOf(randomView(random, 5), randomStar(random, 0.6));
        trim.area.symmetry = plane;
        trim.area.side = i % 3 ? ViewArea::Side::Inside : ViewArea::Side::Outside;
        change = applyToCopy(*mesh, trim);
        if (change.refusal != ModelRefusal::None)
            continue;
        ++done;
        mesh->swap(change.delta);
        VERIFY_VALID(*mesh);
        VERIFY_SYMMETRIC(*mesh, plane);
    }
    QVERIFY2(done > rounds / 2, qPrintable(QString::number(done)));
}

void TestTrim::curveBeside_changesNothing()
{
    const auto mesh = sculptable(icosphere(3, 1));
    // outside the model's rectangle, and in a corner of it that the ball does not reach
    for (const auto& curve : {circle(0.5, 20, {3, 0}), circle(0.05, 20, {0.9, 0.9})}) {
        Trim trim = trimOf(frontView, curve);
        ModelChange change = applyToCopy(*mesh, trim);
        QVERIFY(change.refusal == ModelRefusal::None && !change.changes);
        trim.area.side = ViewArea::Side::Outside;
        change = applyToCopy(*mesh, trim);
        QVERIFY(change.refusal == ModelRefusal::NothingLeft && !change.changes);
    }
}

void TestTrim::everything_isNotCutAway()
{
    const auto mesh = sculptable(icosphere(3, 1));
    Trim trim = trimOf(frontView, circle(2, 20));
    QVERIFY(applyToCopy(*mesh, trim).refusal == ModelRefusal::NothingLeft);
    trim.area.side = ViewArea::Side::Outside;
    const ModelChange change = applyToCopy(*mesh, trim);
    QVERIFY(change.refusal == ModelRefusal::None && !change.changes);
}

void TestTrim::badCurves_areRefused()
{
    const auto mesh = sculptable(icosphere(3, 1));
    const std::vector<std::vector<Eigen::Vector2d>> curves = {{},
                                                              {{0, 0}},
                                                              {{0, 0}, {1, 0}},
                                                              {{0, 0}, {0, 0}, {0, 0}},
                                                              {{0, 0}, {0.5, 0.25}, {1, 0.5}},
                                                              {{0, 0}, {1, 0}, {1, 1}, {1, 0}}};
    for (const auto& curve : curves)
        for (const bool isPerspective : {false, true}) {
            View view = frontView;
            view.isPerspective = isPerspective;
            QVERIFY(applyToCopy(*mesh, trimOf(view, curve)).refusal == ModelRefusal::NoOutline);
        }
    Trim around = trimOf(frontView, circle(1, 8));
    around.area.eye = Vec3::Zero();
    QVERIFY(applyToCopy(*mesh, around).refusal == ModelRefusal::NoOutline);
    around = trimOf(frontView, {{0, 0}, {1, 0}, {0, std::nan("")}});
    QVERIFY(applyToCopy(*mesh, around).refusal == ModelRefusal::NoOutline);
}

/// Tests that a cut leaves the model behind the eye as it is.
void TestTrim::eyeWithinTheModel_cutsWhatIsBefore()
{
    const auto mesh = sculptable(icosphere(4, 1));
    Trim trim = trimOf(frontView, circle(0.5, 40));
    for (Vec3& p : trim.area.outline)
        p.z() = -1;
    trim.area.eye = Vec3::Zero();
    const double removed = removedBy(*mesh, trim);
    QVERIFY2(removed > 0.1 && removed < 0.3, qPrintable(QString::number(removed)));
    for (const Slot v : mesh->vertices())
        QVERIFY(mesh->point(v).z() < 0.01F || mesh->point(v).norm() > 0.99F);
    const ModelChange change = applyToCopy(*mesh, [&] {
        trim.area.eye = Vec3(0, 0, -5);
        for (Vec3& p : trim.area.outline)
            p.z() = -6;
        return trim;
    }());
    QVERIFY(change.refusal == ModelRefusal::None && !change.changes);
}

void TestTrim::colorsAndMasks_areKept()
{
    const Rgb left{10, 20, 30}, right{200, 0, 0}, caps{0, 0, 255};
    const auto mesh = sculptable(icosphere(4, 1));
    mesh->beginStroke();
    for (const Slot v : mesh->vertices()) {
        mesh->setColor(v, mesh->point(v).x() < 0 ? left : right);
        mesh->setMask(v, mesh->point(v).x() < 0 ? 255 : 7);
    }
    mesh->endStroke();
    const auto before = placesOf(*mesh);
    Trim trim = trimOf(frontView, {{-5, 0.13}, {5, 0.13}, {5, 9}, {-5, 9}});
    trim.color = caps;
    QVERIFY(removedBy(*mesh, trim) > 0);
    int onCut = 0;
    for (const Slot v : mesh->vertices()) {
        const LatticePoint p = mesh->latticePoint(v);
        if (isNear(before, p)) {
            QCOMPARE(mesh->color(v), mesh->point(v).x() < 0 ? left : right);
            QCOMPARE(mesh->mask(v), mesh->point(v).x() < 0 ? 255 : 7);
        } else {
            QCOMPARE(mesh->mask(v), 0);
            onCut += mesh->color(v) == caps;
        }
    }
    QVERIFY(onCut > 20);
}

/// The faces of the cut are about as large as the model's, so that it can be sculpted at once.
void TestTrim::cutFaces_areAsFineAsTheModel()
{
    const auto mesh = sculptable(icosphere(5, 1));
    const double longest = checkMesh(extractMesh(*mesh)).maxEdge;
    QVERIFY(removedBy(*mesh, trimOf(frontView, circle(0.5, 200))) > 0);
    QVERIFY(checkMesh(extractMesh(*mesh)).maxEdge < 2 * longest);
}

void TestTrim::stopped_changesNothing()
{
    const auto mesh = sculptable(icosphere(4, 1));
    std::stop_source source;
    source.request_stop();
    const ModelChange change = applyToCopy(*mesh, trimOf(frontView, circle(0.5, 40)), {source.get_token(), {}});
    QVERIFY(!change.changes && change.refusal == ModelRefusal::None);
}

/// Tests that new vertices lie on the plane, and that both sides of it add up to the whole.
void TestTrim::plane_cutsFlat()
{
    StrokeFuzzer random(36);
    // the boolean rounds each coordinate by at most half a unit of a lattice that is up to four times coarser
    constexpr double flat = 4;
    double farthest = 0; // lattice units
    for (int i = 0; i < byEffort(20, 200); ++i) {
        const auto mesh = sculptable(i % 2 ? icosphere(4, 1) : shapes::torus());
        const double whole = volumeOf(*mesh);
        const Box box = boxAround(*mesh);
        const auto signedUnit = [&] { return random.uniform(-1, 1); };
        const Vec3 normal =
            i < 6 ? Vec3(Vec3::Unit(i % 3) * (i < 3 ? 5 : -5)) : Vec3(signedUnit(), signedUnit(), signedUnit() + 0.01);
        const Vec3 point =
            box.center() + 0.35 * box.sizes().cwiseProduct(Vec3(signedUnit(), signedUnit(), signedUnit()));
        const auto before = placesOf(*mesh);
        double sum = 0;
        for (const Vec3& side : {normal, Vec3(-normal)}) {
            ModelChange change = applyToCopy(*mesh, trimBeyond(point, side, box));
            QVERIFY2(change.refusal == ModelRefusal::None, qPrintable(QString::number(i)));
            mesh->swap(change.delta);
            VERIFY_VALID(*mesh);
            sum += volumeOf(*mesh);
            for (const Slot v : mesh->vertices()) {
                const double above = (mesh->point(v).cast<double>() - point).dot(side.normalized());
                const bool isNew = !isNear(before, mesh->latticePoint(v));
                farthest = std::max(farthest, (isNew ? std::abs(above) : above) / mesh->lattice().unit());
            }
            mesh->swap(change.delta);
        }
        QVERIFY2(std::abs(sum / whole - 1) < 1e-5, qPrintable(QString::number(i)));
    }
    QVERIFY2(farthest < flat, qPrintable(QString::number(farthest)));
}

void TestTrim::symmetricPlanes_keepTheSymmetry_data()
{
    symmetricModel_remainsSymmetric_data();
}

/// Cuts symmetric models along random planes, a third of which are their own mirror image, and another third of which
/// nearly are.
void TestTrim::symmetricPlanes_keepTheSymmetry()
{
    QFETCH(const Symmetry, plane);
    const int axis = static_cast<int>(plane) - static_cast<int>(Symmetry::X);
    int done = 0;
    const std::uint64_t first = numberFromEnvironment("FETTLE_SEED", 3'600), count = byEffort(12u, 24u, 300u);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const std::string where = "seed " + std::to_string(seed);
        StrokeFuzzer random(seed);
        const auto mesh = sculptable(seed % 2 ? icosphere(3, 1) : clay::bowl());
        ModelChange half = applyToCopy(*mesh, Symmetrize{plane, Half::Positive});
        mesh->swap(half.delta);
        const double whole = volumeOf(*mesh), unit = mesh->lattice().unit();
        const std::uint64_t hash = mesh->stateHash();
        const Box box = boxAround(*mesh);
        const auto signedUnit = [&] { return random.uniform(-1, 1); };
        Vec3 normal(signedUnit(), signedUnit(), signedUnit());
        normal[axis] *= seed % 3 == 0 ? 0 : seed % 3 == 1 ? 1 : 1e-4;
        const Vec3 point =
            box.center() + 0.35 * box.sizes().cwiseProduct(Vec3(signedUnit(), signedUnit(), signedUnit()));
        Trim trim = trimBeyond(point, normal, box, plane);
        double sum = 0;
        for (const auto side : {ViewArea::Side::Inside, ViewArea::Side::Outside}) {
            trim.area.side = side;
            ModelChange change = applyToCopy(*mesh, trim);
            const bool isLeft = change.refusal != ModelRefusal::NothingLeft;
            QVERIFY2(!isLeft || change.refusal == ModelRefusal::None, where.c_str());
            if (!change.changes) {
                sum += isLeft ? whole : 0;
                continue;
            }
            ++done;
            mesh->swap(change.delta);
            const std::string unsound = mesh_asserts::unsoundness(*mesh);
            QVERIFY2(unsound.empty(), (where + ": " + unsound).c_str());
            const std::string asymmetry = mirror_asserts::asymmetry(*mesh, plane);
            QVERIFY2(asymmetry.empty(), (where + ": " + asymmetry).c_str());
            for (const Slot v : mesh->vertices()) {
                const Vec3 p = mesh->point(v).cast<double>();
                const double above = std::max((p - point).dot(normal), (mirrored(p, plane) - point).dot(normal));
                QVERIFY2(side == ViewArea::Side::Outside || above < 8 * unit * normal.norm(), where.c_str());
            }
            sum += volumeOf(*mesh);
            mesh->swap(change.delta);
            QVERIFY2(mesh->stateHash() == hash, where.c_str());
        }
        const double area = checkMesh(extractMesh(*mesh)).area;
        QVERIFY2(std::abs(sum - whole) < 1e-5 * whole + 4 * unit * area, where.c_str());
    }
    QVERIFY2(done > static_cast<int>(count), qPrintable(QString::number(done)));
}

/// A plane that contains the mirror normal's direction is cut once, also if it deviates by rounding.
void TestTrim::ownImage_isCutOnce()
{
    const auto mesh = sculptable(icosphere(4, 1));
    const double whole = volumeOf(*mesh);
    const Box box = boxAround(*mesh);
    for (const double by : {0.0, 1e-9, -1e-7}) {
        const Vec3 point(0.3, 0, 0.2), normal(by, 1, 0);
        QVERIFY(mirroredPlane(point, normal, box, Symmetry::X) == MirroredPlane::Same);
        ModelChange change = applyToCopy(*mesh, trimBeyond(point, normal, box, Symmetry::X));
        QVERIFY(change.changes);
        mesh->swap(change.delta);
        VERIFY_VALID(*mesh);
        VERIFY_SYMMETRIC(*mesh, Symmetry::X);
        QVERIFY(std::abs(volumeOf(*mesh) / whole - 0.5) < 1e-5);
        mesh->swap(change.delta);
    }
    QVERIFY(mirroredPlane({0.3, 0, 0.2}, {0.01, 1, 0}, box, Symmetry::X) == MirroredPlane::Other);
    QVERIFY(mirroredPlane({0.3, 0, 0.2}, {0, 1, 0}, box, Symmetry::None) == MirroredPlane::None);
}

/// Cutting along the plane of symmetry takes the half on the plane's positive side, and no more.
void TestTrim::planeOfSymmetry_halves()
{
    const auto mesh = sculptable(icosphere(4, 1));
    const double whole = volumeOf(*mesh);
    const Box box = boxAround(*mesh);
    for (const double sign : {-3.0, 1.0}) {
        const Vec3 point(1e-7, 0.4, -0.2), normal(sign, 1e-8, 0);
        QVERIFY(mirroredPlane(point, normal, box, Symmetry::X) == MirroredPlane::Turned);
        ModelChange change = applyToCopy(*mesh, trimBeyond(point, normal, box, Symmetry::X));
        QVERIFY(change.changes);
        mesh->swap(change.delta);
        VERIFY_VALID(*mesh);
        QVERIFY(std::abs(volumeOf(*mesh) / whole - 0.5) < 1e-5);
        for (const Slot v : mesh->vertices())
            QVERIFY(sign * mesh->point(v).x() <= 8 * mesh->lattice().unit());
        mesh->swap(change.delta);
    }
    // a plane across the mirror normal, beside the plane of symmetry, leaves the disc between the images
    QVERIFY(mirroredPlane({0.2, 0, 0}, {1, 0, 0}, box, Symmetry::X) == MirroredPlane::Other);
    ModelChange change = applyToCopy(*mesh, trimBeyond({0.2, 0, 0}, {1, 0, 0}, box, Symmetry::X));
    mesh->swap(change.delta);
    VERIFY_VALID(*mesh);
    VERIFY_SYMMETRIC(*mesh, Symmetry::X);
    QVERIFY(std::abs(volumeOf(*mesh) - pi * (0.4 - 2 * 0.008 / 3)) < 0.02);
}

void TestTrim::imagesTogether_mayLeaveNothing()
{
    const auto mesh = sculptable(icosphere(3, 1));
    const std::uint64_t hash = mesh->stateHash();
    const ModelChange change = applyToCopy(*mesh, trimBeyond({0.2, 0, 0}, {-1, 0, 0}, boxAround(*mesh), Symmetry::X));
    QVERIFY(change.refusal == ModelRefusal::NothingLeft && !change.changes);
    QCOMPARE(mesh->stateHash(), hash);
}

/// Tests that a model on one side of the plane of symmetry is cut by a plane on the other side, and by a curve.
void TestTrim::modelBesideThePlaneOfSymmetry_isCutByTheImage()
{
    for (const bool isPlane : {true, false}) {
        const auto mesh = sculptable(shapes::moved(icosphere(4, 1), {9, 0, 0}));
        Trim trim = trimOf(frontView, {{-5, -3}, {-9, -3}, {-9, 3}, {-5, 3}});
        trim.area.symmetry = Symmetry::X;
        if (isPlane)
            trim = trimBeyond({-9, 0, 0}, {1, 0, 0}, boxAround(*mesh), Symmetry::X);
        const double whole = volumeOf(*mesh);
        if (isPlane) {
            QVERIFY(applyToCopy(*mesh, trim).refusal == ModelRefusal::NothingLeft);
            trim = trimBeyond({-9, 0, 0}, {-1, 0, 0}, boxAround(*mesh), Symmetry::X);
        }
        QVERIFY(std::abs(removedBy(*mesh, trim) / whole - 0.5) < 1e-4);
    }
}

/// The clay beyond the plane and beyond its image becomes one part, which is symmetric, too.
void TestTrim::symmetricSplit_isOnePart()
{
    const auto mesh = sculptable(icosphere(4, 1));
    const double whole = volumeOf(*mesh);
    const std::uint64_t hash = mesh->stateHash();
    const Trim trim = trimBeyond({0.5, 0, 0}, {1, 0.2, 0.1}, boxAround(*mesh), Symmetry::X);
    ModelChange change = applyToCopy(*mesh, SplitPart{trim.area, "sides"}, {}, PartId(0));
    QVERIFY(change.changes);
    mesh->swap(change.delta);
    QCOMPARE(mesh->frame().parts.size(), std::size_t(2));
    for (const PartId part : {PartId(0), PartId(1)})
        VERIFY_SYMMETRIC(*buildMesh(surfaceOf(*mesh, part)).mesh, Symmetry::X);
    const MeshReport sides = checkMesh(surfaceOf(*mesh, 1));
    QCOMPARE(sides.components, std::size_t(2));
    const MeshReport kept = checkMesh(surfaceOf(*mesh, 0));
    QVERIFY(sides.printReady() && kept.printReady());
    QVERIFY(std::abs((*kept.volume + *sides.volume) / whole - 1) < 1e-5);
    mesh->swap(change.delta);
    QCOMPARE(mesh->stateHash(), hash);
}

FETTLE_TEST(TestTrim, QCoreApplication)

#include "tst_trim.moc"
