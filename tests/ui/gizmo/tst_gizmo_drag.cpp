// Drags handles from where they are drawn to where a known transformation takes that point.

#include "ui/gizmo/gizmo_drag.h"

#include "tests/support/test_main.h"
#include "ui/gizmo/gizmo_shape.h"
#include "ui/gizmo/transform_values.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

using core::Vec3;
using ui::GizmoDrag;
using ui::GizmoFrame;
using ui::GizmoHandle;
using Projection = ui::OrbitCamera::Projection;

namespace
{
/// A view of a box of 200 mm from a random side, and a gizmo in it with random axes.
struct View
{
    View(unsigned seed, Projection projection) : random(seed)
    {
        camera.setViewport(900, 700);
        camera.frame({Vec3::Constant(-100), Vec3::Constant(100)});
        camera.setProjection(projection);
        camera.orbit({number(-400, 400), number(-200, 200)});
        frame.centre = Vec3(number(-50, 50), number(-50, 50), number(-50, 50));
        frame.axes = Eigen::Quaterniond(number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1)).normalized();
    }

    double number(double from, double to) { return std::uniform_real_distribution(from, to)(random); }
    QPointF pixel(const Vec3& point) const
    {
        const ui::OrbitCamera::Pixel at = camera.project(point);
        return {at.x(), at.y()};
    }
    /// Returns whether the axis is seen so far from its end that it can be dragged accurately.
    bool isAcross(int axis) const { return std::abs(frame.axis(axis).dot(camera.viewDirection())) < 0.9; }

    std::mt19937 random;
    ui::OrbitCamera camera;
    GizmoFrame frame;
};

GizmoHandle handleOf(GizmoHandle first, int axis)
{
    return static_cast<GizmoHandle>(static_cast<int>(first) + axis);
}
} // namespace

class TestGizmoDrag : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase_data();
    void arrow_movesAlongItsAxis();
    void square_movesInItsPlane();
    void disc_movesParallelToTheView();
    void arc_turnsAboutItsAxis();
    void ring_turnsAboutTheView();
    void box_stretchesAlongItsAxis();
    void innerRing_scalesEvenly();
    void snapping_givesRoundValues();
    void lock_keepsToAnAxis();
    void everyHandle_isFoundWhereItIsDrawn();
    void behindTheEye_thereAreNoHandles();
    void numbers_areTheTransformation();
};

void TestGizmoDrag::initTestCase_data()
{
    QTest::addColumn<unsigned>("seed");
    QTest::addColumn<Projection>("projection");
    for (unsigned seed = 1; seed <= 8; ++seed) {
        QTest::addRow("perspective %u", seed) << seed << Projection::Perspective;
        QTest::addRow("orthographic %u", seed) << seed << Projection::Orthographic;
    }
}

#define VIEW()                                                                                                         \
    QFETCH_GLOBAL(unsigned, seed);                                                                                     \
    QFETCH_GLOBAL(Projection, projection);                                                                             \
    View view(seed, projection)

void TestGizmoDrag::arrow_movesAlongItsAxis()
{
    VIEW();
    for (int axis = 0; axis < 3; ++axis) {
        if (!view.isAcross(axis))
            continue;
        const Vec3 at = view.frame.centre + 20 * view.frame.axis(axis),
                   by = view.number(-15, 30) * view.frame.axis(axis);
        GizmoDrag drag(view.camera, view.frame, handleOf(GizmoHandle::MoveX, axis), view.pixel(at));
        const core::Transform transform = drag.to(view.pixel(at + by), false);
        QVERIFY((transform.by - by).norm() < 1e-6);
        QVERIFY(transform.rotation.isApprox(Eigen::Quaterniond::Identity()) && transform.scale == Vec3::Ones());
    }
}

void TestGizmoDrag::square_movesInItsPlane()
{
    VIEW();
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(view.frame.axis(axis).dot(view.camera.viewDirection())) < 0.2)
            continue;
        const Vec3 by = view.frame.axes * Vec3(axis == 0 ? 0 : 7, axis == 1 ? 0 : -3, axis == 2 ? 0 : 4);
        GizmoDrag drag(view.camera, view.frame, handleOf(GizmoHandle::MoveYZ, axis), view.pixel(view.frame.centre));
        QVERIFY((drag.to(view.pixel(view.frame.centre + by), false).by - by).norm() < 1e-6);
    }
}

void TestGizmoDrag::disc_movesParallelToTheView()
{
    VIEW();
    const Vec3 by = 12 * view.camera.right() - 5 * view.camera.up();
    GizmoDrag drag(view.camera, view.frame, GizmoHandle::MoveView, view.pixel(view.frame.centre));
    QVERIFY((drag.to(view.pixel(view.frame.centre + by), false).by - by).norm() < 1e-6);
}

/// Follows the arc by more than a half turn, in small steps as a pointer does.
void TestGizmoDrag::arc_turnsAboutItsAxis()
{
    VIEW();
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 about = view.frame.axis(axis);
        if (std::abs(about.dot(view.camera.viewDirection())) < 0.3)
            continue;
        const Vec3 arm = 15 * view.frame.axis((axis + 1) % 3);
        GizmoDrag drag(view.camera, view.frame, handleOf(GizmoHandle::TurnX, axis),
                       view.pixel(view.frame.centre + arm));
        const double whole = seed % 2 == 0 ? 3.5 : -2;
        core::Transform transform;
        for (int step = 1; step <= 20; ++step) {
            const Vec3 turned = Eigen::AngleAxisd(whole * step / 20, about) * arm;
            transform = drag.to(view.pixel(view.frame.centre + turned), false);
        }
        QVERIFY(transform.rotation.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(whole, about))) < 1e-6);
        QVERIFY(transform.by.isZero() && transform.centre == view.frame.centre);
    }
}

void TestGizmoDrag::ring_turnsAboutTheView()
{
    VIEW();
    const Vec3 arm = 30 * view.camera.right(), turned = 30 * view.camera.up(); // a quarter turn anticlockwise
    GizmoDrag drag(view.camera, view.frame, GizmoHandle::TurnView, view.pixel(view.frame.centre + arm));
    const Eigen::Quaterniond rotation = drag.to(view.pixel(view.frame.centre + turned), false).rotation;
    QVERIFY((rotation * arm - turned).norm() < 1e-6);
}

void TestGizmoDrag::box_stretchesAlongItsAxis()
{
    VIEW();
    for (int axis = 0; axis < 3; ++axis) {
        if (!view.isAcross(axis))
            continue;
        const Vec3 at = 10 * view.frame.axis(axis);
        GizmoDrag drag(view.camera, view.frame, handleOf(GizmoHandle::ScaleX, axis),
                       view.pixel(view.frame.centre + at));
        const core::Transform transform = drag.to(view.pixel(view.frame.centre + 1.7 * at), false);
        QVERIFY((transform.placeOf(view.frame.centre + at, 1) - view.frame.centre - 1.7 * at).norm() < 1e-6);
        const Vec3 across = view.frame.axis((axis + 1) % 3);
        QVERIFY((transform.placeOf(view.frame.centre + across, 1) - view.frame.centre - across).norm() < 1e-9);
        QVERIFY(drag.to(view.pixel(view.frame.centre - at), false).scale[axis] > 0); // never turned inside out
    }
}

void TestGizmoDrag::innerRing_scalesEvenly()
{
    VIEW();
    const QPointF centre = view.pixel(view.frame.centre), from = centre + QPointF(18, 0);
    GizmoDrag drag(view.camera, view.frame, GizmoHandle::ScaleAll, from);
    QCOMPARE(drag.to(from, false).scale, Vec3::Ones().eval());
    const Vec3 larger = drag.to(centre + QPointF(60, 0), false).scale, smaller = drag.to(centre, false).scale;
    QVERIFY(larger.x() > 1.2 && larger == Vec3::Constant(larger.x()));
    QVERIFY(smaller.x() < 0.9 && smaller == Vec3::Constant(smaller.x()));
}

void TestGizmoDrag::snapping_givesRoundValues()
{
    VIEW();
    const QPointF centre = view.pixel(view.frame.centre);
    const auto isMultiple = [](double value, double step) { return std::abs(std::remainder(value, step)) < 1e-9; };
    GizmoDrag moving(view.camera, view.frame, GizmoHandle::MoveView, centre);
    const double step = ui::roundStep(8 / view.camera.pixelsPerMm(view.frame.centre));
    const Vec3 by = view.frame.axes.conjugate() * moving.to(centre + QPointF(131, -77), true).by;
    QVERIFY(isMultiple(by.x(), step) && isMultiple(by.y(), step) && isMultiple(by.z(), step) && by.norm() > step);
    GizmoDrag turning(view.camera, view.frame, GizmoHandle::TurnView, centre + QPointF(100, 0));
    const double angle =
        Eigen::AngleAxisd(turning.to(centre + QPointF(80, -57), true).rotation).angle() * 180 / std::numbers::pi;
    QVERIFY(isMultiple(angle, 15) && angle > 0);
    GizmoDrag scaling(view.camera, view.frame, GizmoHandle::ScaleAll, centre + QPointF(18, 0));
    QVERIFY(isMultiple(scaling.to(centre + QPointF(71, 0), true).scale.x(), 0.1));
    for (const double length : {0.013, 0.9, 1.0, 2.0, 4.9, 77.0})
        QVERIFY(ui::roundStep(length) >= length * (1 - 1e-9) && ui::roundStep(length) <= 2.5 * length);
}

void TestGizmoDrag::lock_keepsToAnAxis()
{
    VIEW();
    const QPointF centre = view.pixel(view.frame.centre), to = centre + QPointF(40, 25);
    GizmoDrag drag(view.camera, view.frame, GizmoHandle::MoveView, centre);
    const Vec3 free = drag.to(to, false).by;
    drag.lockTo(1);
    QVERIFY(drag.to(to, false).by.cross(view.frame.axis(1)).norm() < 1e-6);
    drag.lockTo(2);
    QCOMPARE(drag.handle(), GizmoHandle::MoveZ);
    drag.lockTo(2);
    QVERIFY((drag.to(to, false).by - free).norm() < 1e-9);
    GizmoDrag turning(view.camera, view.frame, GizmoHandle::TurnView, centre + QPointF(100, 0));
    turning.to(centre + QPointF(0, 100), false);
    turning.lockTo(0);
    QCOMPARE(turning.handle(), GizmoHandle::TurnX);
    QVERIFY(turning.to(centre + QPointF(100, 0), false).rotation.isApprox(Eigen::Quaterniond::Identity()));
}

/// All handles are found somewhere, but those of an axis that is seen from its end, and of planes seen from their edge.
void TestGizmoDrag::everyHandle_isFoundWhereItIsDrawn()
{
    VIEW();
    const ui::GizmoShape shape(view.camera, view.frame);
    const QPointF centre = view.pixel(view.frame.centre);
    std::set<GizmoHandle> found;
    for (int y = -150; y <= 150; y += 2) {
        for (int x = -150; x <= 150; x += 2) {
            if (const auto handle = shape.handleAt(centre + QPointF(x, y)))
                found.insert(*handle);
        }
    }
    for (const GizmoHandle handle : {GizmoHandle::MoveView, GizmoHandle::TurnView, GizmoHandle::ScaleAll})
        QVERIFY(found.contains(handle));
    for (int axis = 0; axis < 3; ++axis) {
        const double slant = std::abs(view.frame.axis(axis).dot(view.camera.viewDirection()));
        QVERIFY(found.contains(handleOf(GizmoHandle::TurnX, axis)));
        if (slant < 0.9)
            QVERIFY(found.contains(handleOf(GizmoHandle::MoveX, axis)) &&
                    found.contains(handleOf(GizmoHandle::ScaleX, axis)));
    }
    QVERIFY(!shape.handleAt(centre + QPointF(300, 0)));
    const ui::GizmoShape plain(view.camera, view.frame, ui::GizmoShape::Handles::WithoutScale);
    QVERIFY(plain.handleAt(centre) == GizmoHandle::MoveView);
}

void TestGizmoDrag::behindTheEye_thereAreNoHandles()
{
    VIEW();
    view.camera.setProjection(Projection::Perspective);
    view.frame.centre = view.camera.eye() - 50 * view.camera.viewDirection();
    const ui::GizmoShape shape(view.camera, view.frame);
    for (int x = 0; x < 900; x += 10)
        QVERIFY(!shape.handleAt(QPointF(x, 350)));
}

void TestGizmoDrag::numbers_areTheTransformation()
{
    VIEW();
    const ui::TransformValues values{
        Vec3(1, -2, 3), Vec3(view.number(-170, 170), view.number(-80, 80), view.number(-170, 170)), Vec3(1.5, 0.5, 2)};
    const core::Transform transform = ui::transformOf(values, view.frame);
    const ui::TransformValues again = ui::valuesOf(transform, view.frame);
    QVERIFY((again.move - values.move).norm() < 1e-9 && (again.degrees - values.degrees).norm() < 1e-6 &&
            again.scale == values.scale);
    QVERIFY(ui::transformOf({}, view.frame).isNothing());
    // X is turned first: a turn about X keeps what lies on it, whatever the other numbers are.
    const core::Transform turn = ui::transformOf({Vec3::Zero(), Vec3(90, 0, 90)}, view.frame);
    const Vec3 x = turn.rotation * view.frame.axis(0);
    QVERIFY((x - view.frame.axis(1)).norm() < 1e-9);
}

FETTLE_TEST(TestGizmoDrag, QCoreApplication)

#include "tst_gizmo_drag.moc"
