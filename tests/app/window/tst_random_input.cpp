#include "tests/support/ask_worker.h"
#include "tests/support/effort.h"
#include "tests/support/program.h"
#include "tests/support/test_main.h"

#include "core/analysis/mesh_check.h"
#include "core/mesh/mesh_builder.h"
#include "ui/actions/actions.h"
#include "ui/scene/scene.h"
#include "ui/util/thread_mailbox.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>

#include <random>

using namespace app;

namespace
{
constexpr int smallSeconds = 4, longSeconds = 8, soakSeconds = 150;
constexpr quint64 maxVertices = 60'000; ///< a model with more vertices is reset to its start

/// A simulated user who presses, drags, types and chooses at random in the window and in every dialog that opens.
class RandomInput
{
public:
    RandomInput(Program& program, unsigned seed) : m_program(program), m_random(seed)
    {
        m_answers.callOnTimeout([this] { answer(); });
        m_answers.start(30);
    }

    void act();
    /// Stops answering dialogs and closes open ones.
    void rest();

private:
    int below(int end) { return std::uniform_int_distribution(0, end - 1)(m_random); }
    QPoint placeIn(const QWidget* widget)
    {
        return {below(std::max(1, widget->width())), below(std::max(1, widget->height()))};
    }
    Qt::KeyboardModifiers modifiers();
    QWidget* someWidget();
    void drag(QWidget* widget);
    void wheel(QWidget* widget);
    void type();
    void choose();
    void answer();

    Program& m_program;
    std::mt19937 m_random;
    QTimer m_answers;
    int m_framesToWait = 0;
};

Qt::KeyboardModifiers RandomInput::modifiers()
{
    constexpr Qt::KeyboardModifier held[] = {Qt::NoModifier,      Qt::NoModifier,    Qt::NoModifier,
                                             Qt::ControlModifier, Qt::ShiftModifier, Qt::AltModifier};
    return held[below(std::size(held))];
}

QWidget* RandomInput::someWidget()
{
    QList<QWidget*> shown;
    for (QWidget* widget : m_program.window.findChildren<QWidget*>())
        if (!widget->visibleRegion().isEmpty() && widget->isEnabled())
            shown << widget;
    return shown[below(static_cast<int>(shown.size()))];
}

void RandomInput::drag(QWidget* widget)
{
    constexpr Qt::MouseButton buttons[] = {Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton,
                                           Qt::RightButton};
    const Qt::MouseButton button = buttons[below(std::size(buttons))];
    const Qt::KeyboardModifiers keys = modifiers();
    const QPointer<QWidget> guard(widget);
    QPoint at = placeIn(widget);
    QTest::mousePress(widget, button, keys, at);
    for (int i = below(20); i > 0 && guard; --i) {
        at += QPoint(below(41) - 20, below(41) - 20);
        QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, button, keys);
        QApplication::sendEvent(widget, &move);
        QTest::qWait(below(4));
    }
    if (guard)
        QTest::mouseRelease(widget, button, keys, at);
}

void RandomInput::wheel(QWidget* widget)
{
    const QPoint at = placeIn(widget);
    QWheelEvent turn(at, widget->mapToGlobal(at), {}, {0, 120 * (below(5) - 2)}, Qt::NoButton, modifiers(),
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &turn);
}

void RandomInput::type()
{
    constexpr Qt::Key keys[] = {Qt::Key_Escape, Qt::Key_Return, Qt::Key_Tab, Qt::Key_Space, Qt::Key_Up,
                                Qt::Key_Down,   Qt::Key_0,      Qt::Key_9,   Qt::Key_F,     Qt::Key_A,
                                Qt::Key_X,      Qt::Key_Z,      Qt::Key_T,   Qt::Key_S,     Qt::Key_Minus,
                                Qt::Key_Period, Qt::Key_Home,   Qt::Key_F1,  Qt::Key_R,     Qt::Key_Backspace};
    QWidget* const focus = QApplication::focusWidget();
    const Qt::Key key = keys[below(std::size(keys))];
    QTest::keyClick(focus ? focus : &m_program.window, key,
                    key == Qt::Key_Z ? Qt::KeyboardModifiers(Qt::ControlModifier) : modifiers());
}

/// Triggers a random command, except for quitting and commands that change files.
void RandomInput::choose()
{
    const auto table = ui::actionTable();
    const ui::ActionInfo& row = table[static_cast<std::size_t>(below(static_cast<int>(table.size())))];
    if (const QLatin1StringView id(row.id); row.menu != ui::MenuId::Files && id != QLatin1StringView("file.quit"))
        m_program.window.action(id)->trigger();
}

void RandomInput::act()
{
    if (QWidget* popup = QApplication::activePopupWidget())
        popup->close();
    if (QApplication::activeModalWidget())
        return QTest::qWait(10); // answer() handles the dialog
    if (m_program.document.modelInfo().vertices > maxVertices && !m_program.document.job().isBusy())
        m_program.window.action(QStringLiteral("model.reset"))->trigger();
    switch (below(10)) {
    case 0:
        return wheel(m_program.window.viewport());
    case 1:
        return type();
    case 2:
        return choose();
    case 3:
        return drag(someWidget());
    case 4:
        return QTest::mouseClick(m_program.window.viewport(), Qt::LeftButton, modifiers(),
                                 placeIn(m_program.window.viewport()));
    case 5:
        return m_program.window.resize(640 + below(300), 480 + below(200));
    default:
        return drag(m_program.window.viewport());
    }
}

/// Sends keys and clicks to an open dialog, and closes it after a while.
void RandomInput::answer()
{
    if (QWidget* popup = QApplication::activePopupWidget()) {
        popup->close();
        return;
    }
    QWidget* const modal = QApplication::activeModalWidget();
    if (!modal) {
        m_framesToWait = 6;
        return;
    }
    if (--m_framesToWait < 0) {
        modal->close();
        return;
    }
    const QList<QWidget*> children = modal->findChildren<QWidget*>();
    const QPointer<QWidget> child = children.isEmpty() ? modal : children[below(static_cast<int>(children.size()))];
    if (child->isVisible())
        QTest::mouseClick(child, Qt::LeftButton, {}, placeIn(child));
}

void RandomInput::rest()
{
    m_answers.stop();
    for (QWidget* open = nullptr;
         (open = QApplication::activePopupWidget()) || (open = QApplication::activeModalWidget());) {
        open->close();
        QTest::qWait(20);
    }
}
} // namespace

/// Random input to the real window for minutes (FETTLE_EFFORT=soak) or seconds. Errors are crashes, best found by
/// sanitizers, unsound models, and steps that cannot be undone and redone.
class TestRandomInput : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theModelStaysSound_data();
    void theModelStaysSound();
};

void TestRandomInput::theModelStaysSound_data()
{
    QTest::addColumn<unsigned>("seed");
    QTest::newRow("20261121") << 20261121u;
}

void TestRandomInput::theModelStaysSound()
{
    if (!ui::graphicsProblem().isEmpty())
        QSKIP("There is no OpenGL here.");
    QFETCH(unsigned, seed);
    Program program;
    program.window.resize(800, 600); // small, because the view is drawn in software
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.document.opener().openBall();
    QTRY_VERIFY(!program.document.job().isBusy());
    {
        RandomInput hand(program, seed);
        QElapsedTimer clock;
        clock.start();
        const int seconds = byEffort(smallSeconds, longSeconds, soakSeconds);
        int acts = 0;
        for (; clock.elapsed() < 1000 * seconds; ++acts)
            hand.act();
        hand.rest();
        qInfo("%d acts, %d steps to undo", acts, program.document.history().stack().count());
    }
    program.window.viewport()->input()->finish();
    program.document.cancelJob();
    QTRY_VERIFY(program.document.queue().isSettled() && !program.document.job().isBusy());

    const auto isPrintReady = [](core::Sculptor& sculptor) {
        return core::checkMesh(core::extractMesh(sculptor.mesh())).printReady();
    };
    QVERIFY(ask(program.worker, isPrintReady));
    const int last = program.document.history().stack().index();
    const std::uint64_t before = meshHash(program.worker);
    program.document.history().goTo(0);
    QVERIFY(ask(program.worker, isPrintReady));
    program.document.history().goTo(last);
    QCOMPARE(program.document.history().stack().index(), last);
    QCOMPARE(meshHash(program.worker), before);
}

static int randomInputMain(int argc, char* argv[])
{
    const QTemporaryDir home; // dialogs write their files here
    qputenv("HOME", home.path().toLocal8Bit());
    ui::prepareGraphics();
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("FettleTest"));
    QCoreApplication::setApplicationName(QStringLiteral("tst_random_hand"));
    TestRandomInput test;
    return QTest::qExec(&test, argc, argv);
}

FETTLE_TEST_MAIN(TestRandomInput, randomInputMain)
#include "tst_random_input.moc"
