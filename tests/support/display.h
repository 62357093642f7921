#pragma once

#include <QByteArray>

namespace test
{
inline bool hasX11()
{
    return !qEnvironmentVariableIsEmpty("DISPLAY");
}

inline bool hasDisplay()
{
    return hasX11() || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
}

/// Chooses Qt's platform for the application that is constructed next.
inline void useOffscreenUnless(bool canBeShown)
{
    if (!canBeShown)
        qputenv("QT_QPA_PLATFORM", QByteArrayLiteral("offscreen"));
}
} // namespace test
