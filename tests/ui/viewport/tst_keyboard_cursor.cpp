#include "ui/viewport/keyboard_cursor.h"

#include <QKeyEvent>
#include <QTest>

using ui::KeyHand;
using ui::OrbitCamera;

namespace
{
/// A hand over a view of 800 x 600 whose model answers every question: there is surface everywhere, or nowhere.
struct Desk
{
    ui::BrushSettings brush;
    OrbitCamera camera;
    ui::PointerInput input{&brush, &camera};
    KeyHand hand{&input};
    int begun = 0, ended = 0, views = 0;
    std::vector<core::StrokeSample> samples;
    core::StrokeSettings settings;

    explicit Desk(bool hasModel = true)
    {
        camera.setViewport(800, 600);
        QObject::connect(&input, &ui::PointerInput::hoverRequested, &input, [this, hasModel] {
            QMetaObject::invokeMethod(
                &input,
                [this, hasModel] { input.setHover(hasModel ? std::optional(core::SurfaceHit{}) : std::nullopt); },
                Qt::QueuedConnection);
        });
        QObject::connect(&input, &ui::PointerInput::strokeBegan, &input, [this](const core::StrokeSettings& s) {
            ++begun;
            settings = s;
        });
        QObject::connect(&input, &ui::PointerInput::strokeSampled, &input,
                         [this](const core::StrokeSample& s) { samples.push_back(s); });
        QObject::connect(&input, &ui::PointerInput::strokeEnded, &input, [this] { ++ended; });
        QObject::connect(&input, &ui::PointerInput::viewChanged, &input, [this] { ++views; });
        hand.setReach({{800, 600}, 40});
        hand.setOn(true);
        settle();
    }

    static void settle()
    {
        for (int i = 0; i < 4; ++i)
            QCoreApplication::processEvents();
    }
    void press(int key, Qt::KeyboardModifiers held = {}, bool again = false)
    {
        QVERIFY(hand.press(QKeyEvent(QEvent::KeyPress, key, held, {}, again)));
        settle();
    }
    void release(int key)
    {
        hand.release(QKeyEvent(QEvent::KeyRelease, key, {}));
        settle();
    }
    void tap(int key, Qt::KeyboardModifiers held = {})
    {
        press(key, held);
        release(key);
    }
};
} // namespace

class TestKeyHand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itBeginsInTheMiddleAndStaysInTheView()
    {
        Desk desk;
        QCOMPARE(desk.hand.at(), OrbitCamera::Pixel(400, 300));
        desk.press(Qt::Key_Left);
        for (int i = 0; i < 200; ++i)
            desk.press(Qt::Key_Left, {}, true);
        QCOMPARE(desk.hand.at(), OrbitCamera::Pixel(0, 300));
        desk.hand.setReach({{100, 100}, 40});
        QCOMPARE(desk.hand.at(), OrbitCamera::Pixel(0, 99));
    }

    /// A tap is a fine step, a key that is held hurries.
    void aHeldKeyGoesFarther()
    {
        Desk desk;
        desk.tap(Qt::Key_Right);
        const double first = desk.hand.at().x() - 400;
        QCOMPARE(first, 5.0);
        desk.press(Qt::Key_Right);
        for (int i = 0; i < 20; ++i)
            desk.press(Qt::Key_Right, {}, true);
        desk.release(Qt::Key_Right);
        const double before = desk.hand.at().x();
        QVERIFY(before - 400 > 15 * 2 * first);
        desk.tap(Qt::Key_Right);
        QCOMPARE(desk.hand.at().x() - before, first);
    }

    void twoKeysGoAslant()
    {
        Desk desk;
        desk.press(Qt::Key_Right);
        desk.press(Qt::Key_Up);
        QCOMPARE(desk.hand.at(), OrbitCamera::Pixel(410, 295));
        desk.release(Qt::Key_Right);
        desk.press(Qt::Key_Up, {}, true);
        QCOMPARE(desk.hand.at().x(), 410.0);
    }

    void spaceSculptsWhileItIsHeld()
    {
        Desk desk;
        desk.press(Qt::Key_Space);
        QCOMPARE(desk.begun, 1);
        QVERIFY(desk.hand.isDown() && desk.ended == 0);
        const std::size_t before = desk.samples.size();
        desk.press(Qt::Key_Space, {}, true); // the keyboard says it again
        desk.tap(Qt::Key_Right);
        QVERIFY(desk.samples.size() > before);
        desk.release(Qt::Key_Space);
        QVERIFY(!desk.hand.isDown());
        QCOMPARE(desk.ended, 1);
        QCOMPARE(desk.begun, 1);
    }

    void returnHoldsUntilTheNextReturn()
    {
        Desk desk;
        desk.tap(Qt::Key_Return);
        QVERIFY(desk.hand.isDown() && desk.begun == 1 && desk.ended == 0);
        desk.tap(Qt::Key_Down);
        desk.tap(Qt::Key_Return);
        QVERIFY(!desk.hand.isDown());
        QCOMPARE(desk.ended, 1);
    }

    void keysThatInvertAndSmoothCount()
    {
        Desk desk;
        desk.tap(Qt::Key_Space, Qt::ControlModifier);
        QCOMPARE(desk.settings.tool, core::Tool::Push);
        desk.tap(Qt::Key_Space, Qt::ShiftModifier);
        QCOMPARE(desk.settings.tool, core::Tool::Smooth);
        desk.brush.setTurnedRound(true);
        desk.tap(Qt::Key_Space);
        QCOMPARE(desk.settings.tool, core::Tool::Push);
        desk.tap(Qt::Key_Space, Qt::ControlModifier);
        QCOMPARE(desk.settings.tool, core::Tool::Pull);
    }

    void besideTheModelTheViewTurns()
    {
        Desk desk(false);
        const core::Vec3 before = desk.camera.viewDirection();
        desk.press(Qt::Key_Space);
        desk.tap(Qt::Key_Right);
        desk.release(Qt::Key_Space);
        QCOMPARE(desk.begun, 0);
        QVERIFY(desk.camera.viewDirection() != before);
    }

    void offItLetsGo()
    {
        Desk desk;
        desk.press(Qt::Key_Return);
        desk.hand.setOn(false);
        QCOMPARE(desk.ended, 1);
        QVERIFY(!desk.hand.press(QKeyEvent(QEvent::KeyPress, Qt::Key_Left, {})));
        QVERIFY(!desk.input.hover());
    }

    void otherKeysAreOthers()
    {
        Desk desk;
        QVERIFY(!desk.hand.press(QKeyEvent(QEvent::KeyPress, Qt::Key_Escape, {})));
        QVERIFY(!desk.hand.press(QKeyEvent(QEvent::KeyPress, Qt::Key_P, {})));
    }
};

QTEST_GUILESS_MAIN(TestKeyHand)
#include "tst_keyboard_cursor.moc"
