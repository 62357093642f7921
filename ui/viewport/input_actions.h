#pragma once

#include <QString>

#include <functional>

class QMainWindow;
class QMenu;

namespace ui
{
class Actions;
class BrushSettings;
class Settings;
class Viewport;

struct HandPlace
{
    QMainWindow* window;
    QMenu* toggles; ///< where the docks' entries are
    Viewport* viewport;
    std::function<void(const QString&)> notice; ///< says a small word
};

/// The commands that change what the hand does next in the view: values by moving the pointer, the steady stroke, a
/// ball, and the turntable with its dock. What is to be remembered is taken from the settings now and written there
/// when it changes. None is owned.
void connectHand(const HandPlace& place, BrushSettings* brush, Settings* settings, const Actions& actions);
} // namespace ui
