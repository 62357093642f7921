#pragma once

#include "tests/support/display.h"
#include "tests/support/test_main.h"
#include "ui/scene/scene.h"
#include "ui/viewport/viewport.h"

#include <QApplication>
#include <QDropEvent>
#include <QImage>
#include <QMimeData>
#include <QMouseEvent>
#include <QTest>
#include <QUrl>

namespace ui
{
/// The QApplication of the tests. Without a display it uses Qt's offscreen platform, on which tests that need OpenGL
/// are skipped.
class TestApplication
{
public:
    TestApplication(int& argc, char** argv) : m_application(prepared(argc), argv) {}

private:
    static int& prepared(int& argc)
    {
        test::useOffscreenUnless(test::hasDisplay());
        prepareGraphics();
        QCoreApplication::setOrganizationName(QStringLiteral("FettleTest"));
        QCoreApplication::setApplicationName(test::runningClass());
        return argc;
    }

    QApplication m_application;
};
} // namespace ui

#define SKIP_WITHOUT_GRAPHICS()                                                                                        \
    if (const QString unable = ui::graphicsProblem(); !unable.isEmpty())                                               \
    QSKIP(qPrintable(unable))

/// Sends a mouse event directly to a widget. QTest::mouseMove() moves the real pointer, whose events the window system
/// may drop.
inline void sendMouse(QWidget* to, QEvent::Type type, QPoint at, Qt::MouseButton button = Qt::NoButton,
                      Qt::KeyboardModifiers modifiers = Qt::NoModifier)
{
    QMouseEvent event(type, at, to->mapToGlobal(at), button, button, modifiers);
    QCoreApplication::sendEvent(to, &event);
}

/// Returns the bounding rectangle of the pixels that differ. Precondition: both pictures have the same size.
inline QRect changed(const QImage& a, const QImage& b)
{
    QRect area;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (a.pixel(x, y) != b.pixel(x, y))
                area |= QRect(x, y, 1, 1);
    return area;
}

/// Returns the number of pixels that are not fully transparent.
inline int inked(const QImage& picture)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += qAlpha(picture.pixel(x, y)) > 0 ? 1 : 0;
    return count;
}

/// Drops files from the desktop on a window. Returns true if the window accepts them.
inline bool drop(QWidget& window, const QList<QUrl>& urls)
{
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    if (!enter.isAccepted())
        return false;
    QDropEvent event({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
    return event.isAccepted();
}
