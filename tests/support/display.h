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

/// Selects Qt's offscreen platform for the next application unless `canBeShown`.
inline void useOffscreenUnless(bool canBeShown)
{
    if (!canBeShown)
        qputenv("QT_QPA_PLATFORM", QByteArrayLiteral("offscreen"));
}
} // namespace test
