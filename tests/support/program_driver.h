#pragma once

#include "tests/support/display.h"
#include "tests/support/program.h"
#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMouseEvent>
#include <QTest>
#include <QTimer>

/// User actions on the program, performed with real events.
namespace app
{
inline QPoint middle(const QWidget* widget)
{
    return widget->rect().center();
}

inline void drag(QWidget* widget, const QPoint& by, Qt::KeyboardModifiers modifiers = {})
{
    constexpr int steps = 12;
    const QPoint from = middle(widget);
    QTest::mousePress(widget, Qt::LeftButton, modifiers, from);
    for (int i = 1; i <= steps; ++i) {
        QMouseEvent move(QEvent::MouseMove, from + by * i / steps, widget->mapToGlobal(from + by * i / steps),
                         Qt::NoButton, Qt::LeftButton, modifiers);
        QApplication::sendEvent(widget, &move);
        QTest::qWait(5);
    }
    QTest::mouseRelease(widget, Qt::LeftButton, modifiers, from + by);
}

/// The application of a test that needs a real window. Without a display ctest reports the test as skipped.
class OnScreen
{
public:
    OnScreen(int& argc, char** argv) : m_application(prepared(argc), argv)
    {
        QCoreApplication::setOrganizationName(QStringLiteral("Fettle"));
        QCoreApplication::setApplicationName(test::runningClass());
    }

    static const char* missing() { return test::hasDisplay() ? nullptr : "there is no display"; }

private:
    static int& prepared(int& argc)
    {
        ui::prepareGraphics();
        return argc;
    }

    QApplication m_application;
};

/// Opens a model from a file, and waits until the window is visible and active.
inline void openFile(Program& program, const QString& path, const QSize& size = {1200, 800})
{
    program.window.resize(size);
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    Q_EMIT program.window.files()->openRequested(path);
    QTRY_COMPARE(program.document.modelInfo().path, path);
    QTRY_VERIFY(!program.document.job().isBusy());
    QTRY_VERIFY(program.window.viewport()->stats().patches > 0);
    program.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&program.window));
}

/// Opens a ball of clay and sculpts one stroke, so that the document has unsaved changes.
inline void sculptBall(Program& program)
{
    program.window.resize(900, 700);
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.document.opener().openBall();
    QTRY_VERIFY(!program.document.job().isBusy());
    QTRY_VERIFY(program.window.viewport()->stats().patches > 0);
    drag(program.window.viewport(), {40, 20});
    QTRY_COMPARE(program.document.history().stack().count(), 1);
    QTRY_VERIFY(program.document.queue().isSettled());
}

/// Presses a button in the question about unsaved changes that will appear next. Repeats the press until the dialog
/// closes, because a busy machine may lose a press on a new dialog.
inline void answerQuestion(Program& program, QMessageBox::StandardButton button)
{
    auto* timer = new QTimer(&program.window);
    QObject::connect(timer, &QTimer::timeout, &program.window, [timer, button, &program] {
        auto* question = program.window.findChild<QMessageBox*>(QStringLiteral("discardQuestion"));
        if (!question || !question->isVisible())
            return;
        QObject::connect(question, &QDialog::finished, timer, &QObject::deleteLater);
        QTest::mouseClick(question->button(button), Qt::LeftButton);
    });
    timer->start(20);
}

/// Enters a file name in the file dialog and presses Return. The text is set at once rather than typed, because the
/// dialog's completion may interfere before the last letter.
inline void chooseFile(Program& program, const char* dialogName, const QString& path)
{
    QFileDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = program.window.findChild<QFileDialog*>(QLatin1StringView(dialogName))) &&
                dialog->isVisible());
    auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    dialog->setDirectory(QFileInfo(path).absolutePath());
    name->setText(QFileInfo(path).fileName());
    // an inactive dialog would leave Return to the window behind it
    QTRY_VERIFY(dialog->isActiveWindow());
    QTest::keyClick(name, Qt::Key_Return);
}

inline QString notice(const Program& program)
{
    const auto* banner = program.window.findChild<QLabel*>(QStringLiteral("banner"));
    return banner->isVisible() ? banner->text() : QString();
}
} // namespace app
