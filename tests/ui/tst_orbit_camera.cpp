#include "ui/orbit_camera.h"

#include <QTest>

#include <random>

using core::Box;
using core::Vec3;
using ui::OrbitCamera;
using Pixel = OrbitCamera::Pixel;

namespace
{
constexpr double tolerance = 1e-6;

OrbitCamera framed(double width = 1280, double height = 720,
                   const Box& box = Box(Vec3(-30, -10, -50), Vec3(40, 60, 20)))
{
    OrbitCamera camera;
    camera.setViewport(width, height);
    camera.frame(box);
    return camera;
}

/// Through both matrices, to a pixel.
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
    void rayAndProjectionAreInverse()
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> x(0, 1280), y(0, 720), along(1, 500);
        OrbitCamera camera = framed();
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
        QTest::newRow("wide") << 1600.0 << 500.0;
        QTest::newRow("tall") << 300.0 << 900.0;
        QTest::newRow("tiny") << 1.0 << 1.0;
    }

    void frameShowsTheWholeBox()
    {
        QFETCH(double, width);
        QFETCH(double, height);
        const Box box(Vec3(100, 200, -50), Vec3(104, 290, -20));
        OrbitCamera camera = framed(width, height, box);
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
            QVERIFY(largest > 0.7); // and not from afar
        }
    }

    void anEmptyBoxIsFramedLikeTheStartingBall()
    {
        OrbitCamera camera = framed(800, 600, Box());
        QCOMPARE(camera.target(), Vec3(0, 0, 0));
        QVERIFY(camera.distance() > 100 && camera.distance() < 1000);
    }

    void orbitTurnsAboutTheTarget()
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

    void panFollowsThePointer()
    {
        OrbitCamera camera = framed();
        const Vec3 held = camera.target();
        const Pixel before = camera.project(held);
        camera.pan({37, -81});
        QVERIFY((camera.project(held) - before - Pixel(37, -81)).norm() < tolerance);
    }

    void zoomHoldsWhatLiesUnderThePointer()
    {
        OrbitCamera camera = framed();
        const Pixel pointer(900, 200);
        const core::Ray ray = camera.ray(pointer);
        const Vec3 held = ray.origin + ray.direction * (camera.distance() / ray.direction.dot(camera.viewDirection()));
        const double before = camera.distance();
        camera.zoom(0.5, pointer);
        QVERIFY(std::abs(camera.distance() - before / 2) < tolerance);
        QVERIFY((camera.project(held) - pointer).norm() < tolerance);
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

    void pixelsPerMmIsWhatAShortLengthCovers()
    {
        const OrbitCamera camera = framed();
        const Vec3 at(10, 20, -5);
        const double covered = (camera.project(at + camera.right()) - camera.project(at)).norm();
        QVERIFY(std::abs(covered - camera.pixelsPerMm(at)) < tolerance);
    }
};

QTEST_APPLESS_MAIN(TestOrbitCamera)
#include "tst_orbit_camera.moc"
