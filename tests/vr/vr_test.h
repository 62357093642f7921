#pragma once

#include "tests/support/display.h"

#include <QGuiApplication>
#include <QOpenGLContext>
#include <QTest>
#include <QtGui/qopenglcontext_platform.h>

namespace vr
{
/// A test's QGuiApplication. Without an X display it uses Qt's offscreen platform, where tests that need GLX skip
/// themselves.
class GlxTestApplication
{
public:
    GlxTestApplication(int& argc, char** argv) : m_application(prepared(argc), argv) {}

private:
    static int& prepared(int& argc)
    {
        test::useOffscreenUnless(test::hasX11());
        return argc;
    }

    QGuiApplication m_application;
};
} // namespace vr

#define SKIP_WITHOUT_GLX()                                                                                             \
    if (const QString unable = glxProblem(); !unable.isEmpty())                                                        \
    QSKIP(qPrintable(unable))

/// Returns why an OpenXR runtime cannot share OpenGL with the test program; empty if it can.
inline QString glxProblem()
{
    QOpenGLContext context;
    if (!context.create())
        return QStringLiteral("no OpenGL on Qt's platform %1").arg(QGuiApplication::platformName());
    return context.nativeInterface<QNativeInterface::QGLXContext>() ? QString()
                                                                    : QStringLiteral("OpenGL does not come by GLX");
}
