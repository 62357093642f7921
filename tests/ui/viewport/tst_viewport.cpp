#include "tests/support/test_main.h"
#include "tests/ui/sphere_model.h"
#include "tests/ui/ui_test.h"

#include <QCursor>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QThread>
#include <QWheelEvent>

#include <chrono>

using core::Tool;

namespace
{
const QPoint onModel{200, 150}, besideModel{8, 8};

using Projection = ui::OrbitCamera::Projection;

void addProjections()
{
    QTest::addColumn<Projection>("projection");
    QTest::newRow("perspective") << Projection::Perspective;
    QTest::newRow("orthographic") << Projection::Orthographic;
}

void turnWheel(ui::Viewport& viewport, QPoint at, int notches)
{
    QWheelEvent event(at, viewport.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&viewport, &event);
}

/// Counts the mouse moves that an object receives.
class MoveCounter : public QObject
{
public:
    explicit MoveCounter(QObject* receiver) { receiver->installEventFilter(this); }

    int moves = 0;

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        moves += event->type() == QEvent::MouseMove ? 1 : 0;
        return false;
    }
};

/// A viewport with a ball, and answers to its hover requests.
struct Stage
{
    explicit Stage(bool answers = true)
    {
        viewport.resize(400, 300);
        viewport.setPatchSource([this] { return std::exchange(next, std::nullopt); });
        if (answers)
            QObject::connect(
                viewport.input(), &ui::PointerInput::hoverRequested, &viewport,
                [this](const core::Ray& ray) { viewport.input()->setHover(model.hit(ray)); }, Qt::QueuedConnection);
        viewport.showModel(model.box());
        viewport.show();
        QVERIFY(QTest::qWaitForWindowExposed(&viewport));
        give(model.whole());
    }

    void give(core::MeshPatch patch)
    {
        const quint64 before = viewport.stats().patches;
        next = std::move(patch);
        viewport.patchReady();
        QTRY_COMPARE(viewport.stats().patches, before + 1);
    }

    void drag(QPoint from, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = Qt::NoModifier)
    {
        sendMouse(&viewport, QEvent::MouseButtonPress, from, button, keys);
        for (int i = 1; i <= 5; ++i)
            sendMouse(&viewport, QEvent::MouseMove, from + QPoint(4 * i, 2 * i), Qt::NoButton, keys);
        sendMouse(&viewport, QEvent::MouseButtonRelease, from + QPoint(20, 10), button, keys);
        QCoreApplication::processEvents();
    }

    SphereModel model;
    std::optional<core::MeshPatch> next;
    ui::BrushSettings brush;
    ui::Viewport viewport{&brush};
};

QRect aroundPixel(const ui::OrbitCamera::Pixel& at, int distance)
{
    const QPoint p(qRound(at.x()), qRound(at.y()));
    return QRect(p - QPoint(distance, distance), p + QPoint(distance, distance));
}
} // namespace

class TestViewport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GRAPHICS(); }

    void theClayIsShown()
    {
        Stage s;
        const QImage picture = s.viewport.grabFramebuffer();
        QCOMPARE(picture.size(), s.viewport.size() * s.viewport.devicePixelRatioF());
        const QColor clay = picture.pixelColor(picture.rect().center()), backdrop = picture.pixelColor(2, 2);
        QVERIFY(clay != backdrop);
        QVERIFY(clay.red() > clay.blue() + 20);
        QCOMPARE(s.viewport.stats().wholeUploads, quint64(1));
        QCOMPARE(s.viewport.stats().uploadedBytes,
                 quint64(s.model.vertices() * sizeof(core::DrawVertex) + s.model.faces() * 12));
    }

    void aSmallPatchSendsAndChangesOnlyWhatItSays()
    {
        Stage s;
        const QImage before = s.viewport.grabFramebuffer();
        const quint64 sent = s.viewport.stats().uploadedBytes;

        const auto hit = s.model.hit(s.viewport.camera().ray({200, 150}));
        QVERIFY(hit);
        const core::Slot v = s.model.mesh.triangles[hit->face][0];
        core::MeshPatch patch = s.model.nothing();
        patch.vertexSpans = {{v, 1}};
        patch.vertices = {SphereModel::draw(s.model.mesh.points[v] * 1.06F)};
        s.give(std::move(patch));

        QCOMPARE(s.viewport.stats().uploadedBytes - sent, quint64(sizeof(core::DrawVertex)));
        QCOMPARE(s.viewport.stats().wholeUploads, quint64(1));
        const QRect area = changed(before, s.viewport.grabFramebuffer());
        QVERIFY(area.isValid());
        QVERIFY(aroundPixel(s.viewport.camera().project(hit->position), 40).contains(area));
    }

    /// A patch with more slots than the buffers have keeps the present content, which is not sent again.
    void theBuffersGrow()
    {
        Stage s;
        const QImage before = s.viewport.grabFramebuffer();
        core::MeshPatch patch = s.model.nothing();
        const core::Slot more = 2 * s.model.vertices();
        patch.vertexSpans = {{s.model.vertices(), more}};
        patch.vertices.assign(more, SphereModel::draw(core::Vec3f(0, 1, 0)));
        patch.faceSpans = {{s.model.faces(), 2 * s.model.faces()}};
        patch.faces.assign(2 * s.model.faces(), core::Triangle{0, 0, 0});
        patch.vertexSlots += more;
        patch.faceSlots *= 3;
        const quint64 sent = s.viewport.stats().uploadedBytes;
        s.give(std::move(patch));
        QCOMPARE(s.viewport.stats().uploadedBytes - sent,
                 quint64(more * sizeof(core::DrawVertex) + 2 * s.model.faces() * 12));
        QVERIFY(!changed(before, s.viewport.grabFramebuffer()).isValid());
    }

    void aFreedFaceIsGone()
    {
        Stage s;
        const QImage before = s.viewport.grabFramebuffer();
        const auto hit = s.model.hit(s.viewport.camera().ray({200, 150}));
        core::MeshPatch patch = s.model.nothing();
        patch.faceSpans = {{hit->face, 1}};
        patch.faces = {{0, 0, 0}};
        s.give(std::move(patch));
        QVERIFY(changed(before, s.viewport.grabFramebuffer()).isValid());
    }

    void manyPatchesAreOneFrame()
    {
        Stage s;
        const quint64 frames = s.viewport.stats().frames;
        for (int i = 0; i < 100; ++i)
            s.viewport.patchReady();
        QTRY_VERIFY(s.viewport.stats().frames > frames);
        QCoreApplication::processEvents();
        QVERIFY(s.viewport.stats().frames <= frames + 2);
    }

    void latencyIsCounted()
    {
        Stage s;
        core::MeshPatch patch = s.model.nothing();
        patch.vertexSpans = {{0, 1}};
        patch.vertices = {SphereModel::draw(s.model.mesh.points[0])};
        const auto earlier = std::chrono::steady_clock::now() - std::chrono::milliseconds(30);
        patch.sampledNs = std::chrono::nanoseconds(earlier.time_since_epoch()).count();
        s.give(std::move(patch));
        QVERIFY(s.viewport.stats().latencyMs >= 30);
        QCOMPARE(s.viewport.stats().worstLatencyMs, s.viewport.stats().latencyMs);
    }

    void aDragOnTheModelIsAStroke_data()
    {
        QTest::addColumn<Qt::KeyboardModifiers>("keys");
        QTest::addColumn<int>("tool");
        QTest::newRow("plain") << Qt::KeyboardModifiers() << static_cast<int>(Tool::Pull);
        QTest::newRow("ctrl") << Qt::KeyboardModifiers(Qt::ControlModifier) << static_cast<int>(Tool::Push);
        QTest::newRow("shift") << Qt::KeyboardModifiers(Qt::ShiftModifier) << static_cast<int>(Tool::Smooth);
    }

    void aDragOnTheModelIsAStroke()
    {
        QFETCH(Qt::KeyboardModifiers, keys);
        QFETCH(int, tool);
        Stage s;
        QSignalSpy began(s.viewport.input(), &ui::PointerInput::strokeBegan),
            ended(s.viewport.input(), &ui::PointerInput::strokeEnded);
        QSignalSpy sampled(s.viewport.input(), &ui::PointerInput::strokeSampled);
        const core::Vec3 eye = s.viewport.camera().eye();
        s.drag(onModel, Qt::LeftButton, keys);
        QTRY_COMPARE(ended.count(), 1);
        QCOMPARE(began.count(), 1);
        QCOMPARE(sampled.count(), 6); // the press and five moves
        const auto settings = began[0][0].value<core::StrokeSettings>();
        QCOMPARE(static_cast<int>(settings.tool), tool);
        QCOMPARE(settings.place, core::Placement::Ray);
        QCOMPARE(s.viewport.camera().eye(), eye);
        for (const QList<QVariant>& arguments : sampled) {
            const auto sample = arguments[0].value<core::StrokeSample>();
            QVERIFY(s.model.hit({sample.position, sample.direction}));
            QCOMPARE(sample.pressure, 1.0);
        }
    }

    /// Mouse moves that arrive during a slow frame are queued, and the stroke uses all of them.
    void everyMouseMoveArrives()
    {
        if (QGuiApplication::platformName() != "xcb")
            QSKIP("only Qt's X11 platform compresses mouse moves, and moves of the real pointer are needed");
        Stage s;
        const QPoint from = s.viewport.mapToGlobal(QPoint(50, 150));
        QCursor::setPos(from);
        QTRY_VERIFY(s.viewport.underMouse());
        QTest::qWait(100); // lets other events of entering pass
        MoveCounter counter(&s.viewport);
        constexpr int moves = 40;
        for (int i = 1; i <= moves; ++i)
            QCursor::setPos(from + QPoint(5 * i, 0));
        QThread::msleep(300);
        QTRY_COMPARE(counter.moves, moves);
    }

    void aDragBesideTheModelTurnsTheView()
    {
        Stage s;
        QSignalSpy began(s.viewport.input(), &ui::PointerInput::strokeBegan);
        const core::Vec3 eye = s.viewport.camera().eye();
        s.drag(besideModel);
        QTRY_VERIFY((s.viewport.camera().eye() - eye).norm() > 1);
        QCOMPARE(began.count(), 0);
    }

    void aDialogOverTheViewEndsTheStroke()
    {
        Stage s;
        QSignalSpy ended(s.viewport.input(), &ui::PointerInput::strokeEnded);
        sendMouse(&s.viewport, QEvent::MouseButtonPress, onModel, Qt::LeftButton);
        QTRY_VERIFY(s.viewport.input()->strokeOpen());
        QEvent blocked(QEvent::WindowBlocked);
        QCoreApplication::sendEvent(&s.viewport, &blocked);
        QCOMPARE(ended.count(), 1);
    }

    void thePenGivesItsPressure()
    {
        Stage s;
        QSignalSpy sampled(s.viewport.input(), &ui::PointerInput::strokeSampled),
            ended(s.viewport.input(), &ui::PointerInput::strokeEnded);
        const auto send = [&s](QEvent::Type type, QPointF at, double pressure) {
            const bool moves = type == QEvent::TabletMove;
            QTabletEvent event(type, QPointingDevice::primaryPointingDevice(), at, s.viewport.mapToGlobal(at), pressure,
                               0, 0, 0, 0, 0, Qt::NoModifier, moves ? Qt::NoButton : Qt::LeftButton, Qt::LeftButton);
            QCoreApplication::sendEvent(&s.viewport, &event);
            QVERIFY(event.isAccepted());
        };
        send(QEvent::TabletPress, onModel, 0.25);
        send(QEvent::TabletMove, onModel + QPointF(3.5, 0), 0.75);
        send(QEvent::TabletRelease, onModel + QPointF(3.5, 0), 0);
        QTRY_COMPARE(ended.count(), 1);
        QCOMPARE(sampled.count(), 2);
        QCOMPARE(sampled[0][0].value<core::StrokeSample>().pressure, 0.25);
        QCOMPARE(sampled[1][0].value<core::StrokeSample>().pressure, 0.75);
    }

    /// A flight ends where the whole box is visible at the given yaw and pitch. Clearing a mark that does not exist
    /// does not end the flight.
    void aFlightGoesToWhereABoxIsSeen()
    {
        Stage s;
        const core::Box box = s.model.box();
        const core::Box wide(3 * box.min(), 3 * box.max());
        s.viewport.navigation()->flyTo(wide, -0.8, 0.4);
        s.viewport.navigation()->clearMark();
        QTRY_VERIFY(std::abs(s.viewport.camera().pose().yaw + 0.8) < 1e-9);
        QVERIFY(std::abs(s.viewport.camera().pose().pitch - 0.4) < 1e-9);
        for (int corner = 0; corner < 8; ++corner) {
            const auto at = s.viewport.camera().project(wide.corner(static_cast<core::Box::CornerType>(corner)));
            QVERIFY(QRectF(s.viewport.rect()).contains(QPointF(at.x(), at.y())));
        }
        QCOMPARE(s.viewport.navigation()->box().min(), box.min());
    }

    void theWheelZooms()
    {
        Stage s;
        const double distance = s.viewport.camera().distance();
        turnWheel(s.viewport, onModel, 1);
        QVERIFY(s.viewport.camera().distance() < distance);
        s.viewport.navigation()->frame();
        QCOMPARE(s.viewport.camera().distance(), distance);
    }

    /// While zooming with the wheel until the model fills the view and beyond, the surface stays under the pointer and
    /// the eye stays outside.
    void theWheelNeverRunsThroughTheSurface_data() { addProjections(); }
    void theWheelNeverRunsThroughTheSurface()
    {
        QFETCH(Projection, projection);
        Stage s;
        s.viewport.navigation()->setProjection(projection);
        const QPoint at(230, 120);
        sendMouse(&s.viewport, QEvent::MouseMove, at);
        QTRY_COMPARE(s.viewport.cursor().shape(), Qt::CrossCursor);
        const ui::OrbitCamera& camera = s.viewport.camera();
        const auto held = s.model.hit(camera.ray({230, 120}));
        QVERIFY(held);
        for (int i = 0; i < 30; ++i) {
            turnWheel(s.viewport, at, 1);
            QCoreApplication::processEvents();
            QVERIFY((camera.project(held->position) - ui::OrbitCamera::Pixel(230, 120)).norm() < 1);
            const auto now = s.model.hit(camera.ray({230, 120}));
            QVERIFY(now && (now->position - held->position).norm() < 1e-3);
        }
        QVERIFY(camera.pixelsPerMm(held->position) > 20);
        QEvent left(QEvent::Leave); // removes the brush's tint too
        QCoreApplication::sendEvent(&s.viewport, &left);
        const QColor clay = s.viewport.grabFramebuffer().pixelColor(20, 20);
        QVERIFY(clay.red() > clay.blue() + 20); // the clay fills the view without being clipped
    }

    void theMiddleButtonTurnsWhereTheModelFillsTheView()
    {
        Stage s;
        QSignalSpy began(s.viewport.input(), &ui::PointerInput::strokeBegan);
        turnWheel(s.viewport, onModel, 8);
        const core::Vec3 direction = s.viewport.camera().viewDirection();
        s.drag(onModel, Qt::MiddleButton);
        QVERIFY((s.viewport.camera().viewDirection() - direction).norm() > 0.05);
        s.drag(onModel, Qt::LeftButton, Qt::AltModifier);
        QVERIFY((s.viewport.camera().viewDirection() - direction).norm() > 0.1);
        QCOMPARE(began.count(), 0);
    }

    void theViewTurnsAboutTheLastStroke_data() { addProjections(); }
    void theViewTurnsAboutTheLastStroke()
    {
        QFETCH(Projection, projection);
        Stage s;
        s.viewport.navigation()->setProjection(projection);
        QSignalSpy ended(s.viewport.input(), &ui::PointerInput::strokeEnded);
        s.drag({220, 130});
        QTRY_COMPARE(ended.count(), 1);
        const ui::OrbitCamera& camera = s.viewport.camera();
        const core::Vec3 pivot = camera.pivot();
        QVERIFY(std::abs(pivot.norm() - 50) < 1); // on the ball's surface
        const auto place = camera.project(pivot);
        QVERIFY((place - ui::OrbitCamera::Pixel(230, 135)).norm() < 15);
        s.drag(besideModel, Qt::MiddleButton);
        QVERIFY((camera.project(pivot) - place).norm() < 1e-6);
        s.viewport.showModel(s.model.box());
        QVERIFY(camera.pivot().norm() < 1e-6);
    }

    /// The ball is drawn at the size and place that the camera's rays give.
    void theBallIsDrawnWhereItsRaysMeetIt_data() { addProjections(); }
    void theBallIsDrawnWhereItsRaysMeetIt()
    {
        QFETCH(Projection, projection);
        Stage s;
        s.viewport.navigation()->setProjection(projection);
        s.viewport.navigation()->turnTo(ui::OrbitCamera::Side::Top);
        const QImage picture = s.viewport.grabFramebuffer();
        int wrong = 0;
        for (int y = 0; y < 300; y += 3)
            for (int x = 0; x < 400; x += 3) {
                const QColor color = picture.pixelColor(x, y);
                const bool clay = color.red() > color.blue() + 8;
                wrong += clay != s.model.hit(s.viewport.camera().ray({x + 0.5, y + 0.5})).has_value();
            }
        QVERIFY2(wrong < 40, qPrintable(QString::number(wrong))); // of 13,400 pixels, only some at the rim may differ
    }

    /// Panning an orthographic view changes no shade: the view direction is constant, so shading depends on the normal
    /// alone.
    void inParallelPanningChangesNoShade()
    {
        Stage s;
        s.viewport.navigation()->setProjection(Projection::Orthographic);
        s.viewport.navigation()->turnTo(ui::OrbitCamera::Side::Front);
        const QImage before = s.viewport.grabFramebuffer();
        const core::Vec3 target = s.viewport.camera().target();
        sendMouse(&s.viewport, QEvent::MouseButtonPress, onModel, Qt::RightButton);
        sendMouse(&s.viewport, QEvent::MouseMove, onModel + QPoint(70, -30));
        sendMouse(&s.viewport, QEvent::MouseButtonRelease, onModel + QPoint(70, -30), Qt::RightButton);
        QVERIFY((s.viewport.camera().target() - target).norm() > 5);
        const QImage after = s.viewport.grabFramebuffer();
        int other = 0;
        for (int y = 90; y < 210; ++y)
            for (int x = 140; x < 260; ++x)
                other += before.pixel(x, y) != after.pixel(x + 70, y - 30);
        QVERIFY2(other < 50, qPrintable(QString::number(other))); // of 14,400 pixels, only some at edges of faces
    }

    void strokesHitInParallelToo()
    {
        Stage s;
        s.viewport.navigation()->setProjection(Projection::Orthographic);
        for (int zoomed = 0; zoomed < 2; ++zoomed) {
            QSignalSpy sampled(s.viewport.input(), &ui::PointerInput::strokeSampled),
                ended(s.viewport.input(), &ui::PointerInput::strokeEnded);
            s.drag({180, 120});
            QTRY_COMPARE(ended.count(), 1);
            QCOMPARE(sampled.count(), 6);
            const auto first = sampled[0][0].value<core::StrokeSample>();
            const auto hit = s.model.hit({first.position, first.direction});
            QVERIFY(hit);
            QVERIFY((s.viewport.camera().project(hit->position) - ui::OrbitCamera::Pixel(180, 120)).norm() < 1e-3);
            QVERIFY(hit->position.dot(s.viewport.camera().viewDirection()) < 0); // on the near side
            turnWheel(s.viewport, onModel, 15);
        }
    }

    void twoFingersPinchAndPan()
    {
        Stage s;
        QSignalSpy began(s.viewport.input(), &ui::PointerInput::strokeBegan);
        const ui::OrbitCamera& camera = s.viewport.camera();
        const core::Vec3 direction = camera.viewDirection();
        const core::Vec3 held =
            s.model.hit(camera.ray({210, 140}))->position; // between the fingers, far in front of the target
        const double size = camera.pixelsPerMm(held);
        QTest::touchEvent(&s.viewport, m_finger).press(0, {180, 140});
        QTest::touchEvent(&s.viewport, m_finger).move(0, {180, 140}).press(1, {240, 140});
        QCoreApplication::processEvents(); // delivers the answer
        QTest::touchEvent(&s.viewport, m_finger).move(0, {150, 140}).move(1, {270, 140});
        QVERIFY(std::abs(camera.pixelsPerMm(held) - 2 * size) < 1e-6 * size);
        QVERIFY((camera.project(held) - ui::OrbitCamera::Pixel(210, 140)).norm() < 1e-6);
        QTest::touchEvent(&s.viewport, m_finger).move(0, {190, 120}).move(1, {310, 120});
        QVERIFY((camera.project(held) - ui::OrbitCamera::Pixel(250, 120)).norm() < 1e-6);
        QVERIFY(s.viewport.cursor().shape() != Qt::CrossCursor); // no brush cursor
        QTest::touchEvent(&s.viewport, m_finger).release(0, {190, 120}).move(1, {310, 120});
        // The remaining finger of a gesture makes no stroke
        QTest::touchEvent(&s.viewport, m_finger).move(1, {330, 200});
        QTest::touchEvent(&s.viewport, m_finger).release(1, {330, 200});
        QCoreApplication::processEvents();
        QCOMPARE(camera.viewDirection(), direction);
        QVERIFY((camera.project(held) - ui::OrbitCamera::Pixel(250, 120)).norm() < 1e-6);
        QCOMPARE(began.count(), 0);
    }

    /// Touchpad gestures zoom and pan about the pointer, at the depth of the surface there.
    void aTouchpadPinchesAndPans()
    {
        Stage s;
        sendMouse(&s.viewport, QEvent::MouseMove, {230, 120});
        QTRY_COMPARE(s.viewport.cursor().shape(), Qt::CrossCursor);
        const ui::OrbitCamera& camera = s.viewport.camera();
        const core::Vec3 held = s.model.hit(camera.ray({230, 120}))->position;
        const double size = camera.pixelsPerMm(held);
        const auto send = [&](Qt::NativeGestureType type, double value, QPointF delta) {
            QNativeGestureEvent event(type, QPointingDevice::primaryPointingDevice(), 2, {230, 120}, {230, 120},
                                      s.viewport.mapToGlobal(QPoint(230, 120)), value, delta);
            QCoreApplication::sendEvent(&s.viewport, &event);
        };
        send(Qt::BeginNativeGesture, 0, {});
        send(Qt::ZoomNativeGesture, 0.5, {});
        QVERIFY(std::abs(camera.pixelsPerMm(held) / size - 1.5) < 1e-6);
        QVERIFY((camera.project(held) - ui::OrbitCamera::Pixel(230, 120)).norm() < 1e-6);
        send(Qt::PanNativeGesture, 0, {30, -10});
        QVERIFY((camera.project(held) - ui::OrbitCamera::Pixel(260, 110)).norm() < 1e-6);
        send(Qt::ZoomNativeGesture, -3, {}); // invalid value
        QVERIFY(std::isfinite(camera.distance()) && camera.distance() > 0);
    }

    void oneFingerIsTheLeftButton()
    {
        Stage s;
        QSignalSpy sampled(s.viewport.input(), &ui::PointerInput::strokeSampled),
            ended(s.viewport.input(), &ui::PointerInput::strokeEnded);
        QTest::touchEvent(&s.viewport, m_finger).press(0, onModel);
        QTest::touchEvent(&s.viewport, m_finger).move(0, onModel + QPoint(30, 0));
        QTest::touchEvent(&s.viewport, m_finger).release(0, onModel + QPoint(30, 0));
        QTRY_COMPARE(ended.count(), 1);
        QCOMPARE(sampled.count(), 2);
        QTest::touchEvent(&s.viewport, m_finger).press(0, onModel); // a tap
        QTest::touchEvent(&s.viewport, m_finger).release(0, onModel);
        QTRY_COMPARE(ended.count(), 2);
        QCOMPARE(sampled.count(), 3);

        const core::Vec3 direction = s.viewport.camera().viewDirection();
        QTest::touchEvent(&s.viewport, m_finger).press(0, besideModel);
        QTest::touchEvent(&s.viewport, m_finger).move(0, besideModel + QPoint(40, 0));
        QTest::touchEvent(&s.viewport, m_finger).release(0, besideModel + QPoint(40, 0));
        QTRY_VERIFY((s.viewport.camera().viewDirection() - direction).norm() > 0.05);
        QCOMPARE(ended.count(), 2);
    }

    /// A stroke of one finger ends when a second finger touches.
    void aSecondFingerEndsTheStroke()
    {
        Stage s;
        QSignalSpy ended(s.viewport.input(), &ui::PointerInput::strokeEnded);
        QTest::touchEvent(&s.viewport, m_finger).press(0, onModel);
        QTest::touchEvent(&s.viewport, m_finger).move(0, onModel + QPoint(30, 0));
        QTRY_VERIFY(s.viewport.input()->strokeOpen());
        QTest::touchEvent(&s.viewport, m_finger).move(0, onModel + QPoint(30, 0)).press(1, onModel + QPoint(-60, 0));
        QCOMPARE(ended.count(), 1);
        QTest::touchEvent(&s.viewport, m_finger)
            .release(0, onModel + QPoint(30, 0))
            .release(1, onModel + QPoint(-60, 0));
        QCoreApplication::processEvents();
        QCOMPARE(ended.count(), 1);
    }

    void theCursorLiesWhereThePointerIs()
    {
        Stage s;
        s.brush.setValue(core::Parameter::Radius, 8);
        const QImage before = s.viewport.grabFramebuffer();
        sendMouse(&s.viewport, QEvent::MouseMove, onModel);
        QTRY_COMPARE(s.viewport.cursor().shape(), Qt::CrossCursor);
        const QRect ring = changed(before, s.viewport.grabFramebuffer());
        QVERIFY(ring.isValid());
        const double pixels = 8 * s.viewport.camera().pixelsPerMm(core::Vec3(0, 0, 0)), edge = pixels / 2;
        QVERIFY(aroundPixel({200, 150}, qRound(1.6 * pixels + edge))
                    .contains(ring)); // the tint ends within the faces at the rim
        QVERIFY(ring.width() > pixels);

        QEvent left(QEvent::Leave);
        QCoreApplication::sendEvent(&s.viewport, &left);
        QVERIFY(!changed(before, s.viewport.grabFramebuffer()).isValid());
    }

    void theCursorGrowsWithTheRadius()
    {
        Stage s;
        const QImage before = s.viewport.grabFramebuffer();
        sendMouse(&s.viewport, QEvent::MouseMove, onModel);
        QTRY_COMPARE(s.viewport.cursor().shape(), Qt::CrossCursor);
        s.brush.setValue(core::Parameter::Radius, 6);
        const QRect small = changed(before, s.viewport.grabFramebuffer());
        s.brush.setValue(core::Parameter::Radius, 12);
        const QRect large = changed(before, s.viewport.grabFramebuffer());
        QVERIFY(large.width() > 1.6 * small.width());
    }

    void theBackdropFollowsThePalette()
    {
        Stage s;
        const int light = qGray(s.viewport.grabFramebuffer().pixel(2, 2));
        s.viewport.setPalette(QPalette(QColor(60, 60, 60), QColor(40, 40, 40)));
        QVERIFY(qGray(s.viewport.grabFramebuffer().pixel(2, 2)) < light - 60);
    }

    void aViewThatMovesToAnotherWindowKeepsItsClay()
    {
        Stage s;
        QWidget window;
        window.resize(400, 300);
        s.viewport.setParent(&window);
        s.viewport.setGeometry(0, 0, 400, 300);
        window.show();
        s.viewport.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        const QImage picture = s.viewport.grabFramebuffer();
        QVERIFY(picture.pixelColor(picture.rect().center()).red() >
                picture.pixelColor(picture.rect().center()).blue() + 20);
        s.viewport.setParent(nullptr);
    }

private:
    QPointingDevice* m_finger = QTest::createTouchDevice();
};

FETTLE_TEST(TestViewport, ui::TestApplication)
#include "tst_viewport.moc"
