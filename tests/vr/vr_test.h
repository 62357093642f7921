#pragma once

#include <QGuiApplication>
#include <QOpenGLContext>
#include <QTest>
#include <QtGui/qopenglcontext_platform.h>

/// Without a display Qt's offscreen platform, where tests that need GLX skip themselves.
#define VR_TEST_MAIN(TestClass)                                                                                        \
    int main(int argc, char* argv[])                                                                                   \
    {                                                                                                                  \
        if (qEnvironmentVariableIsEmpty("DISPLAY"))                                                                    \
            qputenv("QT_QPA_PLATFORM", "offscreen");                                                                   \
        QGuiApplication application(argc, argv);                                                                       \
        TestClass test;                                                                                                \
        return QTest::qExec(&test, argc, argv);                                                                        \
    }

#define SKIP_WITHOUT_GLX()                                                                                             \
    if (const QString unable = glxProblem(); !unable.isEmpty())                                                        \
    QSKIP(qPrintable(unable))

/// Why a runtime could not share OpenGL with us here; empty: it can.
inline QString glxProblem()
{
    QOpenGLContext context;
    if (!context.create())
        return QStringLiteral("no OpenGL on Qt's platform %1").arg(QGuiApplication::platformName());
    return context.nativeInterface<QNativeInterface::QGLXContext>() ? QString()
                                                                    : QStringLiteral("OpenGL does not come by GLX");
}
