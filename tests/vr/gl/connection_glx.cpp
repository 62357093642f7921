#include "tests/vr/gl/connection_glx.h"

#include <QGuiApplication>

#include <GL/glx.h>

bool usesQtsConnection()
{
    const auto* x11 = qGuiApp->nativeInterface<QNativeInterface::QX11Application>();
    return x11 && glXGetCurrentDisplay() == x11->display();
}
