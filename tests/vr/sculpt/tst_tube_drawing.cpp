#include "vr/sculpt/tube_drawing.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <random>

using core::TubePoint;
using core::Vec3;

namespace
{
vr::ModelPlacement placement()
{
    vr::ModelPlacement placement(core::Box(Vec3(-20, -20, -20), Vec3(20, 20, 20)));
    placement.place({Eigen::Quaterniond::Identity(), {0, 1.6, 0}});
    placement.turn(0.7);
    return placement;
}

/// Returns the distance of a point from the lines between the points of the path.
double distanceFrom(const std::vector<TubePoint>& path, const Vec3& p)
{
    double nearest = INFINITY;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Vec3 from = path[i - 1].position, way = path[i].position - from;
        const double share = std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p - from - share * way).norm());
    }
    return nearest;
}

/// Draws points with a radius, and ends the tube.
std::optional<core::Primitive> drawn(const std::vector<Vec3>& points, double radius)
{
    vr::TubeDrawing drawing;
    drawing.begin();
    for (const Vec3& p : points)
        drawing.add({p, radius});
    return drawing.end(placement());
}

/// Returns points along a helix, as a hand that trembles by `tremor` mm draws them.
std::vector<Vec3> helix(int count, double turns, double tremor)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-tremor, tremor);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / (count - 1), angle = 6.283 * turns * share;
        points.emplace_back(15 * std::cos(angle) + number(random), 10 * turns * share + number(random),
                            15 * std::sin(angle) + number(random));
    }
    return points;
}
} // namespace

class TestTubeDrawing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tube_followsTheHand();
    void points_areBounded();
    void shortPaths_makeNoTube();
    void outline_isOnTheTube();
};

/// Checks for a calm and a trembling hand that the tube begins and ends where the hand did, follows it, is a sound
/// solid, and that its points are apart.
void TestTubeDrawing::tube_followsTheHand()
{
    for (const double tremor : {0.0, 0.3}) {
        const std::vector<Vec3> points = helix(300, 1, tremor);
        const std::optional<core::Primitive> tube = drawn(points, 2);
        QVERIFY(tube && tube->kind == core::Primitive::Kind::Tube);
        QCOMPARE(tube->path.front().position, points.front());
        QCOMPARE(tube->path.back().position, points.back());
        QVERIFY(tube->path.size() > 6 && tube->path.size() < points.size() / 3);
        for (std::size_t i = 1; i < tube->path.size(); ++i) {
            QCOMPARE(tube->path[i].radius, 2.0);
            QVERIFY((tube->path[i].position - tube->path[i - 1].position).norm() >= 2);
        }
        double most = 0;
        for (const Vec3& p : points)
            most = std::max(most, distanceFrom(tube->path, p));
        QVERIFY2(most < 0.3 + 2 * tremor, qPrintable(QString::number(most)));
        QVERIFY(core::makePrimitive(*tube).mesh);
    }
}

/// Draws for minutes: the path stays within its bounds, and still follows the hand.
void TestTubeDrawing::points_areBounded()
{
    const std::vector<Vec3> points = helix(40'000, 60, 0.1);
    const std::optional<core::Primitive> tube = drawn(points, 0.5);
    QVERIFY(tube && tube->path.size() <= core::PrimitiveLimits::maxProfile);
    QVERIFY(core::judgePrimitive(*tube).fault != core::PrimitiveFault::Path);
    QCOMPARE(tube->path.back().position, points.back());
    double most = 0;
    for (std::size_t i = 0; i < points.size(); i += 10)
        most = std::max(most, distanceFrom(tube->path, points[i]));
    QVERIFY2(most < 3, qPrintable(QString::number(most)));
    vr::TubeDrawing drawing;
    drawing.begin();
    std::vector<vr::Segment> outline;
    for (const Vec3& p : points)
        drawing.add({p, 0.5});
    drawing.outlineTo(placement(), outline);
    QVERIFY(outline.size() > 100 && outline.size() < 2 * vr::TubeDrawing::maxPoints);
}

/// Tries no point, a single place, a hand that shakes in place, and a path a little shorter and a little longer than
/// the least length.
void TestTubeDrawing::shortPaths_makeNoTube()
{
    QVERIFY(!drawn({}, 2));
    QVERIFY(!drawn({Vec3::Zero()}, 2));
    QVERIFY(!drawn(std::vector<Vec3>(50, Vec3(1, 2, 3)), 2));
    std::vector<Vec3> shaking;
    for (int i = 0; i < 200; ++i)
        shaking.emplace_back(0.1 * std::cos(i), 0.1 * std::sin(i), 0);
    QVERIFY(!drawn(shaking, 2));
    const double least = placement().lengthToModel(vr::TubeDrawing::minLength);
    QVERIFY(!drawn({Vec3::Zero(), Vec3(0.9 * least, 0, 0)}, 2));
    const std::optional<core::Primitive> tube = drawn({Vec3::Zero(), Vec3(1.1 * least, 0, 0)}, 2);
    QVERIFY(tube && core::makePrimitive(*tube).mesh);
}

/// Checks that each line of the outline is on the middle of the tube or as far from it as the tube is thick.
void TestTubeDrawing::outline_isOnTheTube()
{
    const std::vector<Vec3> points = helix(300, 1, 0);
    vr::TubeDrawing drawing;
    drawing.begin();
    std::vector<vr::Segment> outline{{Vec3::Zero(), Vec3::Zero()}};
    drawing.outlineTo(placement(), outline);
    QVERIFY(outline.empty());
    std::vector<TubePoint> path;
    for (const Vec3& p : points) {
        path.push_back({p, 2});
        drawing.add(path.back());
    }
    drawing.outlineTo(placement(), outline);
    QVERIFY(outline.size() > 50);
    for (const vr::Segment& edge : outline)
        for (const Vec3& end : {edge.from, edge.to}) {
            const double away = distanceFrom(path, placement().toModel(end));
            QVERIFY2(std::abs(away - 2) < 0.1 || away < 0.1, qPrintable(QString::number(away)));
        }
}

FETTLE_TEST(TestTubeDrawing, QCoreApplication)
#include "tst_tube_drawing.moc"
