// Tests each tool that the paper does not have by measurable properties. Every result must be a valid solid.
#include "core/mesh/normals.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <optional>

using core::DabOutcome;
using core::DabReport;
using core::Mesh;
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
using mesh_asserts::volumeOf;
using std::numbers::pi;

StrokeSettings settingsOf(Tool tool, double radius = 12)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = radius;
    return settings;
}

/// Returns points of the ball in the plane y = 0, between two angles in degrees from the z axis.
std::vector<Vec3> arc(double from, double to, int samples)
{
    std::vector<Vec3> path;
    for (int i = 0; i < samples; ++i) {
        const double angle = (from + (to - from) * i / (samples - 1)) * pi / 180;
        path.push_back(ballRadius * Vec3(std::sin(angle), 0, std::cos(angle)));
    }
    return path;
}

std::vector<Vec3> straight(const Vec3& from, const Vec3& to, int samples)
{
    std::vector<Vec3> path;
    for (int i = 0; i < samples; ++i)
        path.push_back(from + double(i) / (samples - 1) * (to - from));
    return path;
}

template <class Visit> void forEachPoint(const Mesh& mesh, Visit visit)
{
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (mesh.isVertex(v))
            visit(Vec3(mesh.point(v).cast<double>()));
    }
}

double longestEdge(const Mesh& mesh)
{
    double longest = 0;
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (mesh.isVertex(v))
            mesh.forEachOutgoing(v, [&](Slot h) {
                longest = std::max(longest, double((mesh.point(mesh.to(h)) - mesh.point(v)).norm()));
            });
    }
    return longest;
}

double highest(const Mesh& mesh)
{
    double most = 0;
    forEachPoint(mesh, [&](const Vec3& p) { most = std::max(most, p.norm()); });
    return most;
}

double lowest(const Mesh& mesh)
{
    double least = 1e9;
    forEachPoint(mesh, [&](const Vec3& p) { least = std::min(least, p.norm()); });
    return least;
}

/// Returns the sharpest edge along a stroke about y, for each five degrees of it: the angle between the edge's faces,
/// where 180 degrees is flat.
std::vector<double> sharpestAlong(const Mesh& mesh, double halfWidth, double from, double to)
{
    constexpr double perBin = 5;
    std::vector<double> bins(static_cast<std::size_t>((to - from) / perBin), 180);
    for (Slot e = 0; e < mesh.slots().edges; ++e) {
        if (!mesh.isEdge(e))
            continue;
        const Vec3 a = mesh.point(mesh.to(2 * e)).cast<double>(), b = mesh.point(mesh.to(2 * e + 1)).cast<double>(),
                   middle = 0.5 * (a + b);
        const double angle = std::atan2(middle.x(), middle.z()) * 180 / pi;
        if (std::abs(middle.y()) > halfWidth || angle < from || angle >= to || std::abs((b - a).normalized().y()) > 0.7)
            continue;
        const Vec3 left = core::faceNormal(mesh, mesh.face(2 * e)),
                   right = core::faceNormal(mesh, mesh.face(2 * e + 1));
        const double cosine = left.dot(right) / (left.norm() * right.norm());
        double& bin = bins[std::min(bins.size() - 1, static_cast<std::size_t>((angle - from) / perBin))];
        bin = std::min(bin, 180 - std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / pi);
    }
    return bins;
}

struct Segment
{
    Vec3 from, to;
};

/// Returns the edges within `reach` of the plane y = 0, in the half space z > 0, turned back by `turn`.
std::vector<Segment> edgesAlong(const Mesh& mesh, const Eigen::Quaterniond& turn, double reach)
{
    std::vector<Segment> edges;
    for (Slot e = 0; e < mesh.slots().edges; ++e) {
        if (!mesh.isEdge(e))
            continue;
        const Segment edge = {turn.inverse() * mesh.point(mesh.to(2 * e)).cast<double>(),
                              turn.inverse() * mesh.point(mesh.to(2 * e + 1)).cast<double>()};
        if (std::max(std::abs(edge.from.y()), std::abs(edge.to.y())) < reach && edge.from.z() > 0)
            edges.push_back(edge);
    }
    return edges;
}

/// Returns the point of a section of the ball that is nearest to its centre, or farthest from it. The section contains
/// the y axis and is `angle` radians from the z axis. `edges`: what may be cut.
Vec3 crestAt(double angle, const std::vector<Segment>& edges, bool farthest)
{
    const Vec3 along(std::cos(angle), 0, -std::sin(angle));
    std::optional<Vec3> crest;
    for (const auto& [from, to] : edges) {
        const double before = from.dot(along), after = to.dot(along);
        if (before * after > 0 || before == after)
            continue;
        const Vec3 p = from + before / (before - after) * (to - from);
        if (!crest || (farthest ? p.norm() > crest->norm() : p.norm() < crest->norm()))
            crest = p;
    }
    return crest.value();
}

double meanLengthNear(const Vec3& place, double distance, const std::vector<Segment>& edges)
{
    double sum = 0;
    int count = 0;
    for (const auto& [from, to] : edges) {
        if ((0.5 * (from + to) - place).norm() < distance) {
            sum += (to - from).norm();
            ++count;
        }
    }
    return sum / count;
}

double dullest(const std::vector<double>& bins)
{
    return *std::ranges::max_element(bins);
}
} // namespace

class TestTools : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void raisingTools_changeTheVolume_data();
    void raisingTools_changeTheVolume();
    void clay_fillsHollowsFirst();
    void layer_risesToOneHeight();
    void scrape_takesHeightsAlone();
    void pinch_drawsTogether();
    void crease_isSharp_data();
    void crease_isSharp();
    void crease_isStraight_data();
    void crease_isStraight();
    void crease_staysSharp();
    void grab_movesWhatItHeld();
    void grab_keepsTheMeshAsFineAsItWas();
    void grab_alongRaysKeepsToThePlane();
    void grab_farAlongTheSurfaceGoesAllTheWay();
    void grab_ofNothingIsEmpty();
    void grab_farIsStoppedByTheWall();
    void snake_followsItsTip();
    void twist_turns();
    void handAtRest_changesNothing_data();
    void handAtRest_changesNothing();
    void dragged_throughAnotherPart_data();
    void dragged_throughAnotherPart();
    void symmetric_data();
    void symmetric();
    void undone_data();
    void undone();
};

void TestTools::raisingTools_changeTheVolume_data()
{
    QTest::addColumn<Tool>("tool");
    for (const Tool tool : {Tool::Inflate, Tool::Clay, Tool::Layer})
        QTest::newRow(core::name(tool).data()) << tool;
}

void TestTools::raisingTools_changeTheVolume()
{
    QFETCH(Tool, tool);
    const auto raised = ball(), lowered = ball();
    const double before = volumeOf(raised->mesh());
    StrokeSettings settings = settingsOf(tool);
    stroke(*raised, settings, arc(0, 20, 5));
    settings.inverted = true;
    stroke(*lowered, settings, arc(0, 20, 5));
    QVERIFY(volumeOf(raised->mesh()) > before && highest(raised->mesh()) > ballRadius + 0.5);
    QVERIFY(volumeOf(lowered->mesh()) < before && highest(lowered->mesh()) < ballRadius + 0.1);
    QVERIFY(isSound(*raised) && isSound(*lowered));
}

void TestTools::clay_fillsHollowsFirst()
{
    const auto sculptor = ball();
    stroke(*sculptor, settingsOf(Tool::Push, 5), {{0, 0, 50}, {0, 0, 49}, {0, 0, 48}});
    const auto heightAt = [&](double x) { return sculptor->hit({{x, 0, 200}, -Vec3::UnitZ()})->position.z(); };
    const double hollow = heightAt(0), beside = heightAt(7);
    stroke(*sculptor, settingsOf(Tool::Clay, 15), {{0, 0, 50}});
    QVERIFY(heightAt(0) - hollow > 1.2 * (heightAt(7) - beside));
    QVERIFY(heightAt(7) > beside);
    QVERIFY(isSound(*sculptor));
}

void TestTools::layer_risesToOneHeight()
{
    const auto sculptor = ball();
    const StrokeSettings settings = settingsOf(Tool::Layer);
    std::vector<Vec3> path = arc(0, 30, 10);
    for (int again = 0; again < 4; ++again) {
        const std::vector<Vec3> more = arc(again % 2 ? 0 : 30, again % 2 ? 30 : 0, 10);
        path.insert(path.end(), more.begin(), more.end());
    }
    stroke(*sculptor, settings, path);
    const double height = 0.1 * settings.radius;
    QVERIFY2(std::abs(highest(sculptor->mesh()) - ballRadius - height) < 0.15 * height,
             qPrintable(QString::number(highest(sculptor->mesh()))));
    stroke(*sculptor, settings, arc(0, 30, 10)); // a second stroke adds a second layer
    QVERIFY(highest(sculptor->mesh()) > ballRadius + 1.8 * height);
    QVERIFY(isSound(*sculptor));
}

void TestTools::scrape_takesHeightsAlone()
{
    const auto sculptor = ball();
    stroke(*sculptor, settingsOf(Tool::Pull, 5), std::vector<Vec3>(3, Vec3(3, 0, 49.9)));
    stroke(*sculptor, settingsOf(Tool::Push, 5), std::vector<Vec3>(3, Vec3(-6, 0, 49.6)));
    const auto heightAt = [&](double x) { return sculptor->hit({{x, 0, 200}, -Vec3::UnitZ()})->position.z(); };
    StrokeSettings settings = settingsOf(Tool::Scrape, 15);
    for (const bool inverted : {false, true}) {
        const double hill = heightAt(3), hollow = heightAt(-6);
        settings.inverted = inverted;
        stroke(*sculptor, settings, {{0, 0, 50}});
        QVERIFY(inverted ? heightAt(-6) > hollow + 0.3 : heightAt(3) < hill - 0.3);
        QVERIFY(inverted ? heightAt(3) < hill + 0.1 : heightAt(-6) > hollow - 0.1);
        QVERIFY(isSound(*sculptor));
    }
}

void TestTools::pinch_drawsTogether()
{
    const auto countNear = [](const Sculptor& sculptor) {
        double area = 0; // painted area, seen from the front
        const Mesh& mesh = sculptor.mesh();
        for (Slot f = 0; f < mesh.slots().faces; ++f) {
            if (mesh.isFace(f) && mesh.color(mesh.corners(f)[0]) == core::Rgb{1, 2, 3})
                area += 0.5 * core::faceNormal(mesh, f).norm();
        }
        return area;
    };
    for (const bool inverted : {false, true}) {
        const auto sculptor = ball();
        StrokeSettings paint = settingsOf(Tool::Paint, 6);
        paint.falloff = 0;
        paint.color = {1, 2, 3};
        stroke(*sculptor, paint, {{0, 0, 50}});
        const double before = countNear(*sculptor);
        StrokeSettings pinch = settingsOf(Tool::Pinch);
        pinch.inverted = inverted;
        stroke(*sculptor, pinch, std::vector<Vec3>(5, Vec3(0, 0, 50)));
        QVERIFY(inverted ? countNear(*sculptor) > 1.15 * before : countNear(*sculptor) < before / 1.15);
        QVERIFY(isSound(*sculptor));
    }
}

void TestTools::crease_isSharp_data()
{
    QTest::addColumn<double>("radius");
    QTest::addColumn<int>("samples");
    QTest::addColumn<bool>("inverted");
    QTest::newRow("narrow") << 5.0 << 200 << false;
    QTest::newRow("wide") << 10.0 << 100 << false;
    QTest::newRow("wide, slower") << 10.0 << 200 << false;
    QTest::newRow("ridge") << 10.0 << 100 << true;
}

/// The crease must be sharper than 60 degrees along its line.
void TestTools::crease_isSharp()
{
    QFETCH(double, radius);
    QFETCH(int, samples);
    StrokeSettings settings = settingsOf(Tool::Crease, radius);
    QFETCH(bool, inverted);
    settings.inverted = inverted;
    const auto sculptor = ball();
    stroke(*sculptor, settings, arc(-60, 60, samples));
    const double angle = dullest(sharpestAlong(sculptor->mesh(), radius, -50, 50));
    QVERIFY2(angle < 60, qPrintable(QString::number(angle)));
    QVERIFY(inverted ? highest(sculptor->mesh()) > ballRadius + 1 : lowest(sculptor->mesh()) < ballRadius - 1);
    QVERIFY(isSound(*sculptor));
}

void TestTools::crease_isStraight_data()
{
    QTest::addColumn<double>("radius");
    QTest::addColumn<bool>("inverted");
    QTest::addColumn<double>("turn");
    for (const double radius : {3.0, 6.0, 10.0}) {
        for (const bool inverted : {false, true}) {
            for (const double turn : {0.0, 0.4}) {
                QTest::addRow("%s of radius %g, turned by %g", inverted ? "ridge" : "groove", radius, turn)
                    << radius << inverted << turn;
            }
        }
    }
}

/// The lowest line of a groove, and the highest of a ridge, must be within a fifth of an edge of the path.
void TestTools::crease_isStraight()
{
    QFETCH(double, radius);
    QFETCH(bool, inverted);
    QFETCH(double, turn);
    const Eigen::Quaterniond turned = Eigen::Quaterniond(1, turn, turn / 2, -turn).normalized();
    StrokeSettings settings = settingsOf(Tool::Crease, radius);
    settings.inverted = inverted;
    std::vector<Vec3> path = arc(-60, 60, 200);
    for (Vec3& place : path)
        place = turned * place;
    const auto sculptor = ball();
    stroke(*sculptor, settings, path);
    const std::vector<Segment> edges = edgesAlong(sculptor->mesh(), turned, 0.7 * radius);
    for (double degrees = -45; degrees <= 45; degrees += 0.25) {
        const Vec3 crest = crestAt(degrees * pi / 180, edges, inverted);
        const double edgeLength = meanLengthNear(crest, 0.3 * radius, edges);
        QVERIFY2(
            std::abs(crest.y()) < 0.2 * edgeLength,
            qPrintable(
                QStringLiteral("%1 mm, edges of %2 mm, at %3 degrees").arg(crest.y()).arg(edgeLength).arg(degrees)));
    }
}

/// Strokes of other tools three radii away, and across the ends of the crease, must not blunt it.
void TestTools::crease_staysSharp()
{
    const auto sculptor = ball();
    stroke(*sculptor, settingsOf(Tool::Crease, 8), arc(-60, 60, 120));
    const std::vector<double> before = sharpestAlong(sculptor->mesh(), 8, -50, 50);
    QVERIFY(dullest(before) < 60);
    constexpr Tool others[] = {Tool::Smooth, Tool::Flatten, Tool::Pull, Tool::Inflate, Tool::Scrape};
    for (int i = 0; i < 20; ++i) {
        const double along = (-45 + 4.5 * i) * pi / 180, up = 35 * pi / 180;
        const Vec3 at = ballRadius * Vec3(std::sin(along) * std::cos(up), std::sin(up), std::cos(along) * std::cos(up));
        stroke(*sculptor, settingsOf(others[i % 5], 8), {at});
    }
    QCOMPARE(sharpestAlong(sculptor->mesh(), 8, -50, 50), before);
    QVERIFY(isSound(*sculptor));
}

void TestTools::grab_movesWhatItHeld()
{
    const auto sculptor = ball();
    const std::vector<DabReport> reports =
        stroke(*sculptor, settingsOf(Tool::Grab, 20), straight({0, 0, 50}, {0, 0, 90}, 9));
    for (const DabReport& report : reports)
        QCOMPARE(report.outcome, DabOutcome::Committed);
    QVERIFY2(std::abs(highest(sculptor->mesh()) - 90) < 0.5, qPrintable(QString::number(highest(sculptor->mesh()))));
    QVERIFY(isSound(*sculptor));
    // The held vertices stay the same, so moving back restores the surface, except for remeshing.
    const auto there = ball();
    std::vector<Vec3> path = straight({0, 0, 50}, {0, 0, 60}, 6);
    const std::vector<Vec3> back = straight({0, 0, 58}, {0, 0, 50}, 5);
    path.insert(path.end(), back.begin(), back.end());
    stroke(*there, settingsOf(Tool::Grab, 20), path);
    QVERIFY2(highest(there->mesh()) < 51.5 && lowest(there->mesh()) > 49,
             qPrintable(QStringLiteral("%1 %2").arg(highest(there->mesh())).arg(lowest(there->mesh()))));
}

/// Grab used to coarsen the mesh to the detail of the brush, which left facets on a smooth bump.
void TestTools::grab_keepsTheMeshAsFineAsItWas()
{
    const auto sculptor = ball();
    const Slot before = sculptor->mesh().live().vertices;
    const std::vector<DabReport> reports =
        stroke(*sculptor, settingsOf(Tool::Grab, 25), straight({0, 0, 50}, {0, 0, 65}, 9));
    QVERIFY(reports.back().touchedVertices > before / 32); // the held area is large enough to be coarsened
    QVERIFY2(sculptor->mesh().live().vertices >= before, qPrintable(QString::number(sculptor->mesh().live().vertices)));
    QVERIFY(isSound(*sculptor));
}

/// Grab along rays, as with a mouse, moves in the plane perpendicular to the first ray.
void TestTools::grab_alongRaysKeepsToThePlane()
{
    const auto sculptor = ball();
    StrokeSettings settings = settingsOf(Tool::Grab, 20);
    settings.place = core::Placement::Ray;
    sculptor->beginStroke(settings);
    for (const double x : {0.0, 10.0, 20.0, 30.0}) {
        core::StrokeSample sample;
        sample.position = {x, 0, 300};
        sculptor->addSample(sample);
    }
    sculptor->endStroke();
    double farthest = 0;
    forEachPoint(sculptor->mesh(),
                 [&](const Vec3& p) { farthest = p.z() > 49 ? std::max(farthest, p.x()) : farthest; });
    double field = 0; // expected x of the foremost vertex, which began ahead of the brush's centre
    for (double x = 0; x < 20; x += 0.1)
        field = std::max(field, x + 30 * core::falloff(x / 20, settings.falloff));
    QVERIFY2(std::abs(farthest - field) < 1, qPrintable(QStringLiteral("%1 for %2").arg(farthest).arg(field)));
    QVERIFY(isSound(*sculptor));
}

/// A grab along the surface by more than two radii pushes the surface in front of it and does not fold it. It must
/// reach at least 95 % of its way, and 99 % on the way back. Behind it the mesh stays as fine as the brush requires.
void TestTools::grab_farAlongTheSurfaceGoesAllTheWay()
{
    const auto sculptor = ball();
    std::vector<Vec3> path = arc(0, 41, 40);
    const std::vector<Vec3> back = arc(40, 25, 15);
    path.insert(path.end(), back.begin(), back.end());
    const std::vector<DabReport> reports = stroke(*sculptor, settingsOf(Tool::Grab, 18), path);
    QVERIFY(
        std::ranges::all_of(reports, [](const DabReport& report) { return report.outcome == DabOutcome::Committed; }));
    double asked = 0, reached = 0;
    for (std::size_t i = 1; i < 40; ++i) {
        asked += reports[i].asked;
        reached += reports[i].reached;
    }
    QVERIFY2(reached >= 0.95 * asked, qPrintable(QStringLiteral("%1 of %2").arg(reached).arg(asked)));
    for (std::size_t i = 40; i < reports.size(); ++i)
        QVERIFY2(reports[i].reached >= 0.99 * reports[i].asked, qPrintable(QString::number(i)));
    const double longest = longestEdge(sculptor->mesh()), detail = core::edgeBounds(18, 1).detail;
    QVERIFY2(longest < 1.1 * detail, qPrintable(QStringLiteral("%1 for %2").arg(longest).arg(detail)));
    QVERIFY(isSound(*sculptor));
}

void TestTools::grab_ofNothingIsEmpty()
{
    const auto sculptor = ball();
    const std::uint64_t before = sculptor->mesh().stateHash();
    for (const DabReport& report : stroke(*sculptor, settingsOf(Tool::Grab), straight({0, 0, 150}, {0, 0, 0}, 4)))
        QCOMPARE(report.outcome, DabOutcome::Empty);
    QCOMPARE(sculptor->mesh().stateHash(), before);
}

/// One sample moves the pointer by ten metres.
void TestTools::grab_farIsStoppedByTheWall()
{
    const auto sculptor = ball(4);
    const std::vector<DabReport> reports = stroke(*sculptor, settingsOf(Tool::Grab, 20), {{0, 0, 50}, {0, 0, 10'000}});
    QCOMPARE(reports.back().outcome, DabOutcome::EndedEarly);
    QVERIFY(core::shortfallOf(reports.back()) == core::Shortfall::Wall ||
            core::shortfallOf(reports.back()) == core::Shortfall::Capped);
    QVERIFY(isSound(*sculptor));
}

void TestTools::snake_followsItsTip()
{
    const auto sculptor = ball();
    std::vector<Vec3> path = straight({0, 0, 50}, {0, 0, 90}, 21);
    const std::vector<Vec3> bend = straight({0, 2, 90}, {0, 40, 90}, 20);
    path.insert(path.end(), bend.begin(), bend.end());
    stroke(*sculptor, settingsOf(Tool::SnakeHook, 12), path);
    double tip = 0;
    forEachPoint(sculptor->mesh(), [&](const Vec3& p) { tip = p.z() > 80 ? std::max(tip, p.y()) : tip; });
    QVERIFY2(std::abs(tip - 40) < 0.5, qPrintable(QString::number(tip))); // the tip follows the pointer
    QVERIFY(isSound(*sculptor));
}

/// A drag to the right turns the surface counter-clockwise, by one radian per radius. The rim of the brush does not
/// move.
void TestTools::twist_turns()
{
    for (const bool inverted : {false, true}) {
        const auto sculptor = ball();
        StrokeSettings paint = settingsOf(Tool::Paint, 2.5);
        paint.falloff = 0;
        paint.color = {1, 2, 3};
        stroke(*sculptor, paint, {Vec3(6, 0, std::sqrt(2500.0 - 36))});
        StrokeSettings twist = settingsOf(Tool::Twist, 20);
        twist.inverted = inverted;
        stroke(*sculptor, twist, straight({0, 0, 50}, {10, 0, 50}, 6));
        Vec3 sum = Vec3::Zero();
        for (Slot v = 0; v < sculptor->mesh().slots().vertices; ++v) {
            if (sculptor->mesh().isVertex(v) && sculptor->mesh().color(v).r < 60)
                sum += sculptor->mesh().point(v).cast<double>();
        }
        const double turned = std::atan2(sum.y(), sum.x()) * (inverted ? -1 : 1);
        QVERIFY2(turned > 0.25 && turned < 0.55, qPrintable(QString::number(turned)));
        QVERIFY(highest(sculptor->mesh()) < 50.2);
        QVERIFY(isSound(*sculptor));
    }
}

void TestTools::handAtRest_changesNothing_data()
{
    QTest::addColumn<Tool>("tool");
    for (const Tool tool : {Tool::Grab, Tool::SnakeHook, Tool::Twist})
        QTest::newRow(core::name(tool).data()) << tool;
}

void TestTools::handAtRest_changesNothing()
{
    QFETCH(Tool, tool);
    const auto sculptor = ball();
    const std::uint64_t before = sculptor->mesh().stateHash();
    for (const DabReport& report : stroke(*sculptor, settingsOf(tool), std::vector<Vec3>(3, Vec3(0, 0, 50))))
        QCOMPARE(report.outcome, DabOutcome::Committed);
    QCOMPARE(sculptor->mesh().stateHash(), before);
}

void TestTools::dragged_throughAnotherPart_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<bool>("fusion");
    for (const Tool tool : {Tool::Grab, Tool::SnakeHook}) {
        for (const bool fusion : {true, false})
            QTest::addRow("%s, %s", core::name(tool).data(), fusion ? "fusion" : "no fusion") << tool << fusion;
    }
}

/// Drags one finger through the other. In other programs, 79 to 162 pairs of faces then intersect.
void TestTools::dragged_throughAnotherPart()
{
    QFETCH(Tool, tool);
    QFETCH(bool, fusion);
    Sculptor sculptor(mesh_asserts::sculptable(clay::twoFingers(0.1)));
    core::Box box;
    forEachPoint(sculptor.mesh(), [&](const Vec3& p) { box.extend(p); });
    StrokeSettings settings = settingsOf(tool, 0.3);
    settings.fusion = fusion;
    const std::vector<DabReport> reports =
        stroke(sculptor, settings, straight({box.min().x(), 0, 0}, {box.max().x() + 0.3, 0, 0}, 25));
    const bool met = std::ranges::any_of(reports, [](const DabReport& report) { return report.contact; });
    QVERIFY(fusion ? sculptor.totals().fusions > 0 : met);
    QVERIFY(isSound(sculptor));
}

void TestTools::symmetric_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<double>("angle");
    for (std::size_t i = 0; i < core::toolNames().size(); ++i) {
        for (const double angle : {3.0, -40.0}) // across the mirror plane, and beside it
            QTest::addRow("%s, %g", core::toolNames()[i].data(), angle) << static_cast<Tool>(i) << angle;
    }
}

void TestTools::symmetric()
{
    QFETCH(Tool, tool);
    QFETCH(double, angle);
    const auto sculptor = ball();
    StrokeSettings settings = settingsOf(tool);
    settings.symmetry = core::Symmetry::X;
    std::vector<Vec3> path = arc(angle, angle + 15, 6);
    for (std::size_t i = 0; i < path.size(); ++i)
        path[i] += Vec3(0, 0.4 * double(i), 0.9 * double(i));
    for (const DabReport& report : stroke(*sculptor, settings, path))
        QVERIFY(!report.asymmetric && report.outcome != DabOutcome::Empty);
    VERIFY_SYMMETRIC(sculptor->mesh(), core::Symmetry::X);
    QVERIFY(isSound(*sculptor));
}

void TestTools::undone_data()
{
    QTest::addColumn<Tool>("tool");
    for (std::size_t i = 0; i < core::toolNames().size(); ++i)
        QTest::newRow(core::toolNames()[i].data()) << static_cast<Tool>(i);
}

/// hash(A, undo, B) = hash(B): an undone stroke leaves no state of held or raised clay.
void TestTools::undone()
{
    QFETCH(Tool, tool);
    const auto used = ball(), fresh = ball();
    const StrokeSettings settings = settingsOf(tool);
    core::StrokeSample sample;
    used->beginStroke(settings);
    for (const Vec3& at : arc(10, 30, 4)) {
        sample.position = 1.02 * at;
        used->addSample(sample);
    }
    core::MeshDelta delta = used->endStroke();
    used->swap(delta);
    QCOMPARE(used->mesh().stateHash(), fresh->mesh().stateHash());
    for (Sculptor* sculptor : {used.get(), fresh.get()})
        stroke(*sculptor, settings, arc(0, 25, 5));
    QCOMPARE(used->mesh().stateHash(), fresh->mesh().stateHash());
}

FETTLE_TEST(TestTools, QCoreApplication)
#include "tst_tools.moc"
