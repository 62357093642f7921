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
/// The program's graphics. Without a display it is Qt's offscreen platform, where tests that need OpenGL skip
/// themselves.
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

/// QTest::mouseMove moves the real pointer, which the window system may lose; this arrives for certain.
inline void sendMouse(QWidget* to, QEvent::Type type, QPoint at, Qt::MouseButton button = Qt::NoButton,
                      Qt::KeyboardModifiers modifiers = Qt::NoModifier)
{
    QMouseEvent event(type, at, to->mapToGlobal(at), button, button, modifiers);
    QCoreApplication::sendEvent(to, &event);
}

/// Where two pictures of one size differ.
inline QRect changed(const QImage& a, const QImage& b)
{
    QRect area;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (a.pixel(x, y) != b.pixel(x, y))
                area |= QRect(x, y, 1, 1);
    return area;
}

/// Pixels that are not quite transparent.
inline int inked(const QImage& picture)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += qAlpha(picture.pixel(x, y)) > 0 ? 1 : 0;
    return count;
}

/// Files from the desktop; whether the window takes them.
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
