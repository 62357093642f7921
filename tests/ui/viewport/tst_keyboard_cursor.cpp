#include "ui/viewport/keyboard_cursor.h"

#include "tests/support/test_main.h"

#include <QKeyEvent>
#include <QTest>

using ui::KeyboardCursor;
using ui::OrbitCamera;

namespace
{
/// A keyboard cursor over a view of 800 x 600 pixels. All hover requests are answered alike: there is surface
/// everywhere, or nowhere.
struct Fixture
{
    ui::BrushSettings brush;
    OrbitCamera camera;
    ui::PointerInput input{&brush, &camera};
    KeyboardCursor cursor{&input};
    int begun = 0, ended = 0, views = 0;
    std::vector<core::StrokeSample> samples;
    core::StrokeSettings settings;

    explicit Fixture(bool hasModel = true)
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
        cursor.setBounds({{800, 600}, 40});
        cursor.setOn(true);
        settle();
    }

    static void settle()
    {
        for (int i = 0; i < 4; ++i)
            QCoreApplication::processEvents();
    }
    void press(int key, Qt::KeyboardModifiers held = {}, bool again = false)
    {
        QVERIFY(cursor.press(QKeyEvent(QEvent::KeyPress, key, held, {}, again)));
        settle();
    }
    void release(int key)
    {
        cursor.release(QKeyEvent(QEvent::KeyRelease, key, {}));
        settle();
    }
    void tap(int key, Qt::KeyboardModifiers held = {})
    {
        press(key, held);
        release(key);
    }
};
} // namespace

class TestKeyboardCursor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itBeginsInTheMiddleAndStaysInTheView()
    {
        Fixture fixture;
        QCOMPARE(fixture.cursor.at(), OrbitCamera::Pixel(400, 300));
        fixture.press(Qt::Key_Left);
        for (int i = 0; i < 200; ++i)
            fixture.press(Qt::Key_Left, {}, true);
        QCOMPARE(fixture.cursor.at(), OrbitCamera::Pixel(0, 300));
        fixture.cursor.setBounds({{100, 100}, 40});
        QCOMPARE(fixture.cursor.at(), OrbitCamera::Pixel(0, 99));
    }

    /// A tap moves the cursor by a small step; holding the key moves it faster.
    void aHeldKeyGoesFarther()
    {
        Fixture fixture;
        fixture.tap(Qt::Key_Right);
        const double first = fixture.cursor.at().x() - 400;
        QCOMPARE(first, 5.0);
        fixture.press(Qt::Key_Right);
        for (int i = 0; i < 20; ++i)
            fixture.press(Qt::Key_Right, {}, true);
        fixture.release(Qt::Key_Right);
        const double before = fixture.cursor.at().x();
        QVERIFY(before - 400 > 15 * 2 * first);
        fixture.tap(Qt::Key_Right);
        QCOMPARE(fixture.cursor.at().x() - before, first);
    }

    void twoKeysGoAslant()
    {
        Fixture fixture;
        fixture.press(Qt::Key_Right);
        fixture.press(Qt::Key_Up);
        QCOMPARE(fixture.cursor.at(), OrbitCamera::Pixel(410, 295));
        fixture.release(Qt::Key_Right);
        fixture.press(Qt::Key_Up, {}, true);
        QCOMPARE(fixture.cursor.at().x(), 410.0);
    }

    void spaceSculptsWhileItIsHeld()
    {
        Fixture fixture;
        fixture.press(Qt::Key_Space);
        QCOMPARE(fixture.begun, 1);
        QVERIFY(fixture.cursor.isDown() && fixture.ended == 0);
        const std::size_t before = fixture.samples.size();
        fixture.press(Qt::Key_Space, {}, true); // auto-repeat of the keyboard
        fixture.tap(Qt::Key_Right);
        QVERIFY(fixture.samples.size() > before);
        fixture.release(Qt::Key_Space);
        QVERIFY(!fixture.cursor.isDown());
        QCOMPARE(fixture.ended, 1);
        QCOMPARE(fixture.begun, 1);
    }

    void returnHoldsUntilTheNextReturn()
    {
        Fixture fixture;
        fixture.tap(Qt::Key_Return);
        QVERIFY(fixture.cursor.isDown() && fixture.begun == 1 && fixture.ended == 0);
        fixture.tap(Qt::Key_Down);
        fixture.tap(Qt::Key_Return);
        QVERIFY(!fixture.cursor.isDown());
        QCOMPARE(fixture.ended, 1);
    }

    void keysThatInvertAndSmoothCount()
    {
        Fixture fixture;
        fixture.tap(Qt::Key_Space, Qt::ControlModifier);
        QCOMPARE(fixture.settings.tool, core::Tool::Push);
        fixture.tap(Qt::Key_Space, Qt::ShiftModifier);
        QCOMPARE(fixture.settings.tool, core::Tool::Smooth);
        fixture.brush.setInverted(true);
        fixture.tap(Qt::Key_Space);
        QCOMPARE(fixture.settings.tool, core::Tool::Push);
        fixture.tap(Qt::Key_Space, Qt::ControlModifier);
        QCOMPARE(fixture.settings.tool, core::Tool::Pull);
    }

    void besideTheModelTheViewTurns()
    {
        Fixture fixture(false);
        const core::Vec3 before = fixture.camera.viewDirection();
        fixture.press(Qt::Key_Space);
        fixture.tap(Qt::Key_Right);
        fixture.release(Qt::Key_Space);
        QCOMPARE(fixture.begun, 0);
        QVERIFY(fixture.camera.viewDirection() != before);
    }

    void offItLetsGo()
    {
        Fixture fixture;
        fixture.press(Qt::Key_Return);
        fixture.cursor.setOn(false);
        QCOMPARE(fixture.ended, 1);
        QVERIFY(!fixture.cursor.press(QKeyEvent(QEvent::KeyPress, Qt::Key_Left, {})));
        QVERIFY(!fixture.input.hover());
    }

    void otherKeysAreOthers()
    {
        Fixture fixture;
        QVERIFY(!fixture.cursor.press(QKeyEvent(QEvent::KeyPress, Qt::Key_Escape, {})));
        QVERIFY(!fixture.cursor.press(QKeyEvent(QEvent::KeyPress, Qt::Key_P, {})));
    }
};

FETTLE_TEST(TestKeyboardCursor, QCoreApplication)
#include "tst_keyboard_cursor.moc"
