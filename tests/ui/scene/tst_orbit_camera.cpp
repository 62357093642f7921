#include "ui/scene/orbit_camera.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <random>

using core::Box;
using core::Vec3;
using ui::OrbitCamera;
using Pixel = OrbitCamera::Pixel;
using Projection = OrbitCamera::Projection;
using Side = OrbitCamera::Side;

namespace
{
constexpr double tolerance = 1e-6;
const Box someBox(Vec3(-30, -10, -50), Vec3(40, 60, 20));

OrbitCamera framed(double width = 1280, double height = 720, const Box& box = someBox,
                   Projection projection = Projection::Perspective)
{
    OrbitCamera camera;
    camera.setViewport(width, height);
    camera.setProjection(projection);
    camera.frame(box);
    return camera;
}

OrbitCamera framed(Projection projection)
{
    return framed(1280, 720, someBox, projection);
}

void addProjections()
{
    QTest::addColumn<Projection>("projection");
    QTest::newRow("perspective") << Projection::Perspective;
    QTest::newRow("orthographic") << Projection::Orthographic;
}

/// Returns random points in the scene's box.
std::vector<Vec3> points()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<Vec3> all;
    for (int i = 0; i < 50; ++i)
        all.push_back(someBox.min() + Vec3(share(random), share(random), share(random)).cwiseProduct(someBox.sizes()));
    return all;
}

double depthOf(const OrbitCamera& camera, const Vec3& p)
{
    return (p - camera.eye()).dot(camera.viewDirection());
}

/// Projects a point to a pixel using both matrices.
Pixel byMatrices(const OrbitCamera& camera, const Vec3& p)
{
    const Eigen::Vector4d clip = camera.projectionMatrix() * camera.viewMatrix() * p.homogeneous();
    const Pixel size = camera.viewport();
    return {(clip.x() / clip.w() + 1) / 2 * size.x(), (1 - clip.y() / clip.w()) / 2 * size.y()};
}
} // namespace

class TestOrbitCamera : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aTurningModelIsSeenTurned_data() { addProjections(); }

    void aTurningModelIsSeenTurned()
    {
        QFETCH(Projection, projection);
        OrbitCamera camera = framed(projection);
        const OrbitCamera before = camera;
        camera.turnModel(0.7);
        const Eigen::AngleAxisd turned(0.7, Vec3::UnitY());
        for (const Vec3& p : {Vec3(10, 20, 30), Vec3(-30, 0, 5), Vec3(0, 50, 0)})
            QVERIFY((camera.project(p) - before.project(turned * p)).norm() < tolerance);
    }

    void rayAndProjectionAreInverse_data() { addProjections(); }
    void rayAndProjectionAreInverse()
    {
        QFETCH(Projection, projection);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> x(0, 1280), y(0, 720), along(1, 500);
        OrbitCamera camera = framed(projection);
        for (int i = 0; i < 1000; ++i) {
            const Pixel pixel(x(random), y(random));
            const core::Ray ray = camera.ray(pixel);
            const Vec3 point = ray.origin + along(random) * ray.direction;
            QVERIFY((camera.project(point) - pixel).norm() < tolerance);
            QVERIFY((byMatrices(camera, point) - pixel).norm() < tolerance);
            camera.orbit({13, 7});
        }
    }

    void frameShowsTheWholeBox_data()
    {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::addColumn<Projection>("projection");
        QTest::newRow("wide") << 1600.0 << 500.0 << Projection::Perspective;
        QTest::newRow("tall") << 300.0 << 900.0 << Projection::Perspective;
        QTest::newRow("tiny") << 1.0 << 1.0 << Projection::Perspective;
        QTest::newRow("wide, orthographic") << 1600.0 << 500.0 << Projection::Orthographic;
        QTest::newRow("tall, orthographic") << 300.0 << 900.0 << Projection::Orthographic;
    }

    void frameShowsTheWholeBox()
    {
        QFETCH(double, width);
        QFETCH(double, height);
        QFETCH(Projection, projection);
        const Box box(Vec3(100, 200, -50), Vec3(104, 290, -20));
        OrbitCamera camera = framed(width, height, box, projection);
        for (int turn = 0; turn < 20; ++turn) {
            camera.orbit({0.17 * height, 0.09 * height * (turn % 3 - 1)});
            camera.frame(box);
            double largest = 0;
            for (int i = 0; i < 8; ++i) {
                const Vec3 corner = box.corner(static_cast<Box::CornerType>(i));
                const Pixel at = camera.project(corner);
                QVERIFY(at.x() >= 0 && at.x() <= width && at.y() >= 0 && at.y() <= height);
                largest = std::max({largest, std::abs(2 * at.x() / width - 1), std::abs(2 * at.y() / height - 1)});
                const double depth = (corner - camera.eye()).dot(camera.viewDirection());
                QVERIFY(depth > camera.nearPlane() && depth < camera.farPlane());
            }
            QVERIFY(largest > 0.7); // and not too far away
        }
    }

    void anEmptyBoxIsFramedLikeTheStartingBall()
    {
        OrbitCamera camera = framed(800, 600, Box());
        QCOMPARE(camera.target(), Vec3(0, 0, 0));
        QVERIFY(camera.distance() > 100 && camera.distance() < 1000);
    }

    void orbitTurnsAboutTheModelsCentreAtFirst()
    {
        OrbitCamera camera = framed();
        const Vec3 target = camera.target();
        const double distance = camera.distance();
        camera.orbit({200, -90});
        QCOMPARE(camera.target(), target);
        QVERIFY(std::abs((camera.eye() - target).norm() - distance) < tolerance);
        QVERIFY(std::abs(camera.right().dot(camera.up())) < tolerance);
        QVERIFY(std::abs(camera.up().cross(camera.right()).dot(camera.viewDirection()) - 1) < tolerance);
    }

    void theViewsHeightIsHalfATurn()
    {
        OrbitCamera camera = framed();
        const Vec3 before = camera.right();
        camera.orbit({720, 0});
        QVERIFY((camera.right() + before).norm() < tolerance);
    }

    void thePolesAreTheEnd()
    {
        OrbitCamera camera = framed();
        camera.orbit({0, 1e5});
        QVERIFY((camera.viewDirection() - Vec3(0, -1, 0)).norm() < tolerance);
        QVERIFY(camera.up().allFinite() && std::abs(camera.up().norm() - 1) < tolerance);
        camera.orbit({0, -1e5});
        QVERIFY((camera.viewDirection() - Vec3(0, 1, 0)).norm() < tolerance);
    }

    void panFollowsThePointer_data() { addProjections(); }
    void panFollowsThePointer()
    {
        QFETCH(Projection, projection);
        OrbitCamera camera = framed(projection);
        const Vec3 held = camera.target();
        const Pixel before = camera.project(held);
        camera.pan({37, -81});
        QVERIFY((camera.project(held) - before - Pixel(37, -81)).norm() < tolerance);
    }

    void zoomHoldsWhatLiesUnderThePointer_data() { addProjections(); }
    void zoomHoldsWhatLiesUnderThePointer()
    {
        QFETCH(Projection, projection);
        OrbitCamera camera = framed(projection);
        const Pixel pointer(900, 200);
        const core::Ray ray = camera.ray(pointer);
        const double before = camera.distance(), size = camera.pixelsPerMm(camera.target());
        const Vec3 held = ray.origin + 0.999 * (before - depthOf(camera, ray.origin)) * ray.direction;
        camera.zoom(0.5, pointer);
        QVERIFY(std::abs(camera.distance() - before / 2) < tolerance);
        QVERIFY(std::abs(camera.pixelsPerMm(camera.target()) - 2 * size) < tolerance);
        QVERIFY((camera.project(held) - pointer).norm() < tolerance);
    }

    /// The pivot keeps its pixel during an orbit, for any view and any distance of the pivot from the centre.
    void thePivotKeepsItsPlaceInThePicture_data() { addProjections(); }
    void thePivotKeepsItsPlaceInThePicture()
    {
        QFETCH(Projection, projection);
        for (const Vec3& pivot : points()) {
            OrbitCamera camera = framed(projection);
            camera.setPivot(pivot);
            camera.pan({111, -70});
            camera.zoom(0.7, {300, 500});
            const Pixel place = camera.project(pivot);
            const double depth = depthOf(camera, pivot);
            for (const Pixel& by : {Pixel(50, 20), Pixel(-300, 5), Pixel(3, 1e5), Pixel(80, -200)}) {
                const Vec3 before = camera.viewDirection();
                camera.orbit(by);
                QVERIFY((camera.viewDirection() - before).norm() > 1e-3);
                QVERIFY((camera.project(pivot) - place).norm() < tolerance);
                QVERIFY(std::abs(depthOf(camera, pivot) - depth) < tolerance);
            }
            for (const Side side : {Side::Top, Side::Left, Side::Front, Side::Back, Side::Bottom, Side::Right}) {
                camera.turnTo(side);
                QVERIFY((camera.project(pivot) - place).norm() < tolerance);
            }
        }
    }

    void aPivotThatTheSceneHasLeftIsGivenUp()
    {
        OrbitCamera camera = framed();
        const Vec3 corner = someBox.max();
        camera.setPivot(corner);
        camera.setScene(Box(someBox.min(), someBox.max() + Vec3(1, 1, 1)));
        QCOMPARE(camera.pivot(), corner);
        const Box moved(someBox.min() + Vec3(500, 0, 0), someBox.max() + Vec3(500, 0, 0));
        camera.setScene(moved);
        QCOMPARE(camera.pivot(), Vec3(moved.center()));
    }

    void sidesShowTheAxes_data()
    {
        QTest::addColumn<Side>("side");
        QTest::addColumn<int>("rightAxis"); ///< 1, 2, 3: x, y, z; negative: opposite direction
        QTest::addColumn<int>("upAxis");
        QTest::newRow("front") << Side::Front << 1 << 2;
        QTest::newRow("back") << Side::Back << -1 << 2;
        QTest::newRow("right") << Side::Right << -3 << 2;
        QTest::newRow("left") << Side::Left << 3 << 2;
        QTest::newRow("top") << Side::Top << 1 << -3;
        QTest::newRow("bottom") << Side::Bottom << 1 << 3;
    }

    void sidesShowTheAxes()
    {
        QFETCH(Side, side);
        QFETCH(int, rightAxis);
        QFETCH(int, upAxis);
        for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
            OrbitCamera camera = framed(projection);
            camera.orbit({77, -33});
            camera.turnTo(side);
            const auto step = [&](int axis) {
                const Vec3 along = Vec3::Unit(std::abs(axis) - 1) * (axis < 0 ? -1 : 1);
                return Pixel((camera.project(camera.target() + along) - camera.project(camera.target())).normalized());
            };
            QVERIFY((step(rightAxis) - Pixel(1, 0)).norm() < tolerance);
            QVERIFY((step(upAxis) - Pixel(0, -1)).norm() < tolerance);
        }
    }

    /// Equal and parallel segments stay so in an orthographic picture wherever they are; in perspective they do not.
    void parallelsStayParallel_data() { addProjections(); }
    void parallelsStayParallel()
    {
        QFETCH(Projection, projection);
        const OrbitCamera camera = framed(projection);
        const Vec3 along(10, 6, -20);
        double largest = 0;
        for (const Vec3& a : points())
            for (const Vec3& b : points())
                largest = std::max(largest, ((camera.project(a + along) - camera.project(a)) -
                                             (camera.project(b + along) - camera.project(b)))
                                                .norm());
        QVERIFY(projection == Projection::Orthographic ? largest < tolerance : largest > 10);
    }

    void theProjectionKeepsTheSizeAtTheTarget()
    {
        OrbitCamera camera = framed();
        const double size = camera.pixelsPerMm(camera.target());
        camera.setProjection(Projection::Orthographic);
        QVERIFY(std::abs(camera.pixelsPerMm(camera.target()) - size) < tolerance);
        QVERIFY((camera.project(camera.target()) - camera.viewport() / 2).norm() < tolerance);
    }

    void anotherDepthIsTheSamePicture_data() { addProjections(); }
    void anotherDepthIsTheSamePicture()
    {
        QFETCH(Projection, projection);
        for (const Vec3& chosen : points()) {
            OrbitCamera camera = framed(projection);
            const OrbitCamera before = camera;
            camera.setTargetDepth(chosen);
            for (const Vec3& p : points())
                QVERIFY((camera.project(p) - before.project(p)).norm() < tolerance);
            camera.pan({37, -81});
            QVERIFY((camera.project(chosen) - before.project(chosen) - Pixel(37, -81)).norm() < tolerance);
        }
    }

    /// However far the user zooms in, a surface with known depth stays in front of the eye and at its pixel.
    void zoomDoesNotRunThroughTheSurface_data() { addProjections(); }
    void zoomDoesNotRunThroughTheSurface()
    {
        QFETCH(Projection, projection);
        OrbitCamera camera = framed(projection);
        const Vec3 surface = someBox.max();
        const Pixel pointer = camera.project(surface);
        for (int i = 0; i < 200; ++i) {
            camera.setTargetDepth(surface);
            camera.zoom(0.9, pointer);
            QVERIFY((camera.project(surface) - pointer).norm() < 1e-3);
            QVERIFY(depthOf(camera, surface) > camera.nearPlane() && depthOf(camera, surface) < camera.farPlane());
        }
    }

    /// Rays of an orthographic view begin in front of the scene. Otherwise a stroke could begin inside the model.
    void parallelRaysBeginBeforeTheScene()
    {
        OrbitCamera camera = framed(Projection::Orthographic);
        camera.zoom(1e-2, {200, 300});
        for (int i = 0; i < 8; ++i) {
            camera.orbit({90, 40});
            for (const Vec3& p : points())
                QVERIFY((p - camera.ray(camera.project(p)).origin).dot(camera.viewDirection()) > 0);
        }
    }

    void zoomHasEnds()
    {
        OrbitCamera camera = framed();
        for (int i = 0; i < 1000; ++i)
            camera.zoom(0.5, {640, 360});
        QVERIFY(camera.distance() > 0 && camera.nearPlane() > 0);
        for (int i = 0; i < 1000; ++i)
            camera.zoom(2, {640, 360});
        QVERIFY(std::isfinite(camera.distance()) && camera.farPlane() > camera.distance());
    }

    void pixelsPerMmIsWhatAShortLengthCovers_data() { addProjections(); }
    void pixelsPerMmIsWhatAShortLengthCovers()
    {
        QFETCH(Projection, projection);
        const OrbitCamera camera = framed(projection);
        const Vec3 at(10, 20, -5);
        const double covered = (camera.project(at + camera.right()) - camera.project(at)).norm();
        QVERIFY(std::abs(covered - camera.pixelsPerMm(at)) < tolerance);
    }

    void facingAPlaceShowsItInTheMiddle_data() { addProjections(); }

    void facingAPlaceShowsItInTheMiddle()
    {
        QFETCH(Projection, projection);
        const Vec3 place(10, 20, -5);
        for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(-1, -2, 3)}) {
            OrbitCamera camera = framed(projection);
            const OrbitCamera::Pose from = camera.pose(), to = camera.facing(place, normal, 8);
            camera.setPose(to);
            QVERIFY((camera.project(place) - camera.viewport() / 2).norm() < tolerance);
            QVERIFY(camera.viewDirection().dot(normal.normalized()) < -0.9);
            QVERIFY(8 * camera.pixelsPerMm(place) < camera.viewport().y() / 2);
            camera.setPose(OrbitCamera::between(from, to, 0));
            QVERIFY((camera.target() - from.target).norm() < tolerance &&
                    std::abs(camera.distance() - from.distance) < tolerance);
            for (double share = 0; share < 1; share += 0.125) {
                camera.setPose(OrbitCamera::between(from, to, share));
                const double before = (camera.target() - place).norm();
                camera.setPose(OrbitCamera::between(from, to, share + 0.125));
                QVERIFY((camera.target() - place).norm() <= before + tolerance);
            }
        }
    }
};

FETTLE_TEST(TestOrbitCamera)
#include "tst_orbit_camera.moc"
