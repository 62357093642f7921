// Tests where the dabs of a stroke are placed that is drawn by rays, as with a mouse.
#include "core/mesh/normals.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <map>

using core::Sculptor;
using core::Slot;
using core::StrokeSample;
using core::StrokeSettings;
using core::Tool;
using core::Vec3;

namespace
{
using clay::ballRadius;

const Vec3 eye(0, 0, 4 * ballRadius);

/// Returns a sample whose ray goes from the eye through a point of the plane z = 0.
StrokeSample through(double x, double y)
{
    StrokeSample sample;
    sample.position = eye;
    sample.direction = Vec3(x, y, 0) - eye;
    return sample;
}

/// Returns samples on an arc of 120 degrees in the left half of the view.
std::vector<StrokeSample> leftArc(double radius, int samples)
{
    std::vector<StrokeSample> path;
    for (int i = 0; i < samples; ++i) {
        const double angle = (120 + 120.0 * i / (samples - 1)) * M_PI / 180;
        path.push_back(through(radius * std::cos(angle), radius * std::sin(angle)));
    }
    return path;
}

StrokeSettings brush(Tool tool)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.place = core::Placement::Ray;
    settings.radius = 0.2 * ballRadius;
    settings.spacing = 0.25;
    settings.topology = core::Topology::Refine;
    return settings;
}

std::unique_ptr<Sculptor> draw(const StrokeSettings& settings, const std::vector<StrokeSample>& path)
{
    auto sculptor = clay::ball();
    sculptor->beginStroke(settings);
    for (const StrokeSample& sample : path)
        sculptor->addSample(sample);
    sculptor->endStroke();
    return sculptor;
}

template <class Visit> void forEachPlace(const Sculptor& sculptor, Visit visit)
{
    for (Slot v = 0; v < sculptor.mesh().slots().vertices; ++v) {
        if (sculptor.mesh().isVertex(v))
            visit(Vec3(sculptor.mesh().point(v).cast<double>()));
    }
}

/// Returns the height of the ridge every five degrees around the z axis, from 150 to 210 degrees, without the stroke's
/// ends.
std::vector<double> heights(const Sculptor& sculptor)
{
    std::map<int, double> highest;
    forEachPlace(sculptor, [&](const Vec3& p) {
        const int sector = static_cast<int>(std::lround((std::atan2(p.y(), p.x()) * 180 / M_PI + 360) / 5)) % 72;
        for (const int near : {sector - 1, sector, sector + 1})
            highest[near] = std::max(highest[near], p.norm() - ballRadius);
    });
    std::vector<double> heights;
    for (int sector = 30; sector <= 42; ++sector)
        heights.push_back(highest[sector]);
    return heights;
}
} // namespace

class TestStrokeOnSurface : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ridge_isAsHighEverywhere_data();
    void ridge_isAsHighEverywhere();
    void strokeOverTheOutline_endsThere_data();
    void strokeOverTheOutline_endsThere();
    void layer_isAsSmoothAsWhatItRaises();
    void layerThatCrossesItself_isRaisedOnce_data();
    void layerThatCrossesItself_isRaisedOnce();
    void twelveSamplesOfACircle_makeACircle();
    void airbrush_goesOnWhereTheHandRests_data();
    void airbrush_goesOnWhereTheHandRests();
    void strokeTakenBack_leavesTheMeshAsItWas();
};

/// Radii of the arc range from the middle of the view to the outline, where raised clay is in front of the stroke's
/// path.
void TestStrokeOnSurface::ridge_isAsHighEverywhere_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("strength");
    for (const Tool tool : {Tool::Pull, Tool::Inflate, Tool::Clay}) {
        for (const double radius : {0.3, 0.6, 0.8, 0.9, 0.95, 1.0}) {
            for (const double strength : {0.5, 1.0, 2.0})
                QTest::addRow("%s, %g, strength %g", std::string(name(tool)).c_str(), radius, strength)
                    << tool << radius * ballRadius << strength;
        }
    }
}

void TestStrokeOnSurface::ridge_isAsHighEverywhere()
{
    QFETCH(Tool, tool);
    QFETCH(double, radius);
    QFETCH(double, strength);
    StrokeSettings settings = brush(tool);
    settings.strength = strength;
    const auto sculptor = draw(settings, leftArc(radius, 60));
    std::vector<double> ridge = heights(*sculptor);
    std::ranges::sort(ridge);
    const double middle = ridge[ridge.size() / 2];
    QVERIFY(middle > 0.1 * settings.radius * strength);
    QVERIFY2(ridge.front() > 0.85 * middle && ridge.back() < 1.15 * middle,
             qPrintable(QStringLiteral("%1 to %2").arg(ridge.front()).arg(ridge.back())));
    QVERIFY(mesh_asserts::badFaces(sculptor->mesh()).empty());
}

void TestStrokeOnSurface::strokeOverTheOutline_endsThere_data()
{
    QTest::addColumn<Tool>("tool");
    for (const Tool tool : {Tool::Pull, Tool::Inflate, Tool::Clay, Tool::Layer})
        QTest::newRow(std::string(name(tool)).c_str()) << tool;
}

/// The ridge must be as high at the outline as elsewhere. Nothing may rise where the pointer continues beside the ball.
void TestStrokeOnSurface::strokeOverTheOutline_endsThere()
{
    QFETCH(Tool, tool);
    std::vector<StrokeSample> path;
    for (int i = 0; i <= 40; ++i)
        path.push_back(through((-0.3 + 0.04 * i) * ballRadius, (0.2 + 0.5 * std::sin(M_PI * 0.02 * i)) * ballRadius));
    const StrokeSettings settings = brush(tool);
    const auto sculptor = draw(settings, path), untouched = clay::ball();
    std::vector<Vec3> way; // surface points of the path, in steps shorter than 0.1 radii
    for (std::size_t i = 1; i < path.size(); ++i) {
        for (int k = 0; k < 50; ++k) {
            const Vec3 direction = path[i - 1].direction + k / 50.0 * (path[i].direction - path[i - 1].direction);
            if (const auto hit = untouched->hit({eye, direction}))
                way.push_back(hit->position);
        }
    }
    std::vector<double> highest(way.size());
    double elsewhere = 0;
    forEachPlace(*sculptor, [&](const Vec3& p) {
        const Vec3 onBall = ballRadius * p.normalized();
        const double height = p.norm() - ballRadius;
        double nearest = INFINITY;
        for (std::size_t i = 0; i < way.size(); ++i) {
            const double distance = (way[i] - onBall).norm();
            nearest = std::min(nearest, distance);
            if (distance < 0.5 * settings.radius)
                highest[i] = std::max(highest[i], height);
        }
        if (nearest > 1.3 * settings.radius)
            elsewhere = std::max(elsewhere, height);
    });
    double middle = 0, lowest = INFINITY, most = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        if ((way[i] - way.front()).norm() < 2 * settings.radius || (way[i] - way.back()).norm() < settings.radius)
            continue;
        middle = middle > 0 ? middle : highest[i];
        lowest = std::min(lowest, highest[i]);
        most = std::max(most, highest[i]);
    }
    QVERIFY(middle > 0.05 * settings.radius);
    QVERIFY2(lowest > 0.85 * middle && most < 1.15 * middle,
             qPrintable(QStringLiteral("%1 to %2, %3").arg(lowest).arg(most).arg(middle)));
    QVERIFY2(elsewhere < 0.02 * middle, qPrintable(QString::number(elsewhere)));
    QVERIFY(mesh_asserts::badFaces(sculptor->mesh()).empty());
}

/// The top of a layer must have constant height, with angles between faces little larger than on the ball.
void TestStrokeOnSurface::layer_isAsSmoothAsWhatItRaises()
{
    const StrokeSettings settings = brush(Tool::Layer);
    const auto sculptor = draw(settings, leftArc(0.5 * ballRadius, 60));
    const core::Mesh& mesh = sculptor->mesh();
    const double step = 0.1 * settings.radius;
    const auto height = [&](Slot v) { return mesh.point(v).cast<double>().norm() - ballRadius; };
    int raised = 0;
    double turn = 0;
    for (Slot e = 0; e < mesh.slots().edges; ++e) {
        if (!mesh.isEdge(e))
            continue;
        const Slot h = 2 * e;
        const std::array<Slot, 4> corners = {mesh.from(h), mesh.to(h), mesh.to(mesh.next(h)),
                                             mesh.to(mesh.next(h ^ 1))};
        if (std::ranges::any_of(corners, [&](Slot v) { return height(v) < 0.9 * step; }))
            continue;
        ++raised;
        const Vec3 left = core::faceNormal(mesh, mesh.face(h)), right = core::faceNormal(mesh, mesh.face(h ^ 1));
        turn = std::max(turn, std::acos(std::min(left.dot(right) / (left.norm() * right.norm()), 1.0)) * 180 / M_PI);
    }
    int vertices = 0;
    forEachPlace(*sculptor, [&](const Vec3& p) {
        vertices += p.norm() - ballRadius >= 0.9 * step;
        QVERIFY(p.norm() - ballRadius < 1.05 * step);
    });
    QVERIFY(raised > 400 && vertices > 200);
    QVERIFY2(turn < 6, qPrintable(QString::number(turn)));
}

void TestStrokeOnSurface::layerThatCrossesItself_isRaisedOnce_data()
{
    QTest::addColumn<core::Topology>("topology");
    QTest::addColumn<core::Symmetry>("symmetry");
    QTest::addColumn<double>("most"); // largest allowed height, as a multiple of the layer's height
    using core::Topology, core::Symmetry;
    for (const Symmetry symmetry : {Symmetry::None, Symmetry::X}) {
        for (const auto& [topology, most] :
             {std::pair(Topology::Keep, 1.05), {Topology::Refine, 1.4}, {Topology::Adaptive, 1.4}}) {
            QTest::addRow("%s, %s", std::string(name(topology)).c_str(), std::string(name(symmetry)).c_str())
                << topology << symmetry << most;
        }
    }
}

/// Draws a figure eight across the mirror plane. The crossing must be raised once, so only vertices moved by remeshing
/// may be higher than one layer.
void TestStrokeOnSurface::layerThatCrossesItself_isRaisedOnce()
{
    QFETCH(core::Topology, topology);
    QFETCH(core::Symmetry, symmetry);
    QFETCH(double, most);
    StrokeSettings settings = brush(Tool::Layer);
    settings.symmetry = symmetry;
    settings.topology = topology;
    std::vector<StrokeSample> path;
    for (int i = 0; i < 45; ++i)
        path.push_back(through(0.35 * std::sin(0.25 * i) * ballRadius, 0.35 * std::sin(0.5 * i) * ballRadius));
    const auto sculptor = draw(settings, path);
    double highest = 0;
    forEachPlace(*sculptor, [&](const Vec3& p) { highest = std::max(highest, p.norm() - ballRadius); });
    const double steps = highest / (0.1 * settings.radius);
    QVERIFY2(steps > 0.9 && steps < most, qPrintable(QString::number(steps)));
}

/// The ridge must deviate from a circle by less than 2 % of the radius.
void TestStrokeOnSurface::twelveSamplesOfACircle_makeACircle()
{
    constexpr double radius = 0.5 * ballRadius;
    std::vector<StrokeSample> path;
    for (int i = 0; i <= 12; ++i)
        path.push_back(through(radius * std::cos(i * M_PI / 6), radius * std::sin(i * M_PI / 6)));
    StrokeSettings settings = brush(Tool::Pull);
    settings.radius = 0.06 * ballRadius;
    const auto sculptor = draw(settings, path);
    const double onBall = clay::ball()->hit({eye, path[0].direction})->position.head<2>().norm();
    std::map<int, std::pair<double, double>>
        ridge; // key: sector of 6 degrees; value: sums of the weights and of the weighted distances from the axis
    forEachPlace(*sculptor, [&](const Vec3& p) {
        const double height = p.norm() - ballRadius;
        if (p.z() < 0 || height < 0.01 * settings.radius)
            return;
        auto& [heights, distances] = ridge[static_cast<int>(std::floor(std::atan2(p.y(), p.x()) * 30 / M_PI))];
        heights += height;
        distances += height * p.head<2>().norm() * ballRadius / p.norm();
    });
    QCOMPARE(ridge.size(), std::size_t(60));
    for (const auto& [sector, sums] : ridge) {
        const double distance = sums.second / sums.first;
        QVERIFY2(std::abs(distance / onBall - 1) < 0.02,
                 qPrintable(QStringLiteral("%1 of %2").arg(distance).arg(onBall)));
    }
}

void TestStrokeOnSurface::airbrush_goesOnWhereTheHandRests_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<core::Placement>("place");
    QTest::addColumn<double>("strength");
    QTest::addColumn<double>("tremor"); ///< amplitude of the pointer's tremor, in radii
    using core::Placement;
    for (const Tool tool :
         {Tool::Pull, Tool::Push, Tool::Inflate, Tool::Clay, Tool::Smooth, Tool::Pinch, Tool::Paint}) {
        for (const Placement place : {Placement::Point, Placement::Nearest, Placement::Ray}) {
            for (const double strength : {0.1, 1.0}) {
                for (const double tremor : {0.0, 0.01})
                    QTest::addRow("%s, %s, strength %g, tremor %g", std::string(name(tool)).c_str(),
                                  std::string(name(place)).c_str(), strength, tremor)
                        << tool << place << strength << tremor;
            }
        }
    }
}

/// An airbrush gives ten dabs per second, whatever the brush raises under the pointer. The stroke takes two seconds,
/// with 90 samples per second.
void TestStrokeOnSurface::airbrush_goesOnWhereTheHandRests()
{
    QFETCH(Tool, tool);
    QFETCH(core::Placement, place);
    QFETCH(double, strength);
    QFETCH(double, tremor);
    StrokeSettings settings = brush(tool);
    settings.place = place;
    settings.strength = strength;
    settings.airbrush = 10;
    auto sculptor = clay::ball();
    std::size_t dabs = 0;
    sculptor->beginStroke(settings);
    for (int i = 0; i <= 180; ++i) {
        StrokeSample sample = through(i % 2 * tremor * settings.radius, 0);
        if (place != core::Placement::Ray)
            sample.position = Vec3(i % 2 * tremor * settings.radius, 0, ballRadius);
        sample.time = i / 90.0;
        dabs += sculptor->addSample(sample).size();
    }
    sculptor->endStroke();
    QVERIFY2(dabs >= 18 && dabs <= 19, qPrintable(QString::number(dabs)));
    QVERIFY(mesh_asserts::badFaces(sculptor->mesh()).empty());
}

/// Dabs that still wait for a further sample must not be applied.
void TestStrokeOnSurface::strokeTakenBack_leavesTheMeshAsItWas()
{
    auto sculptor = clay::ball();
    const auto points = [&] { return mesh_asserts::surfaceOf(sculptor->mesh()).points; };
    const auto before = points();
    int dabs = 0;
    sculptor->setAfterDab([&](const core::DabReport&) { ++dabs; });
    sculptor->beginStroke(brush(Tool::Pull));
    sculptor->addSample(through(0, 0));
    sculptor->addSample(through(20, 0));
    QCOMPARE(dabs, 1);
    QVERIFY(points() != before);
    QVERIFY(sculptor->endStroke(core::StrokeEnd::TakenBack).empty());
    QCOMPARE(dabs, 1);
    QVERIFY(!sculptor->strokeOpen());
    QVERIFY(points() == before);
    QVERIFY(sculptor->indexIsConsistent());
}

FETTLE_TEST(TestStrokeOnSurface)
#include "tst_stroke_on_surface.moc"
