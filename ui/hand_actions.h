#pragma once

#include <QString>

#include <functional>

namespace ui
{
class Actions;
class BrushSettings;
class Settings;
class Viewport;

using Say = std::function<void(const QString&)>;

/// The commands that change what the hand does next in the view: values by moving the pointer, the steady stroke, a ball. What is to be
/// remembered is taken from the settings now and written there when it changes. None is owned.
void connectHand(const Actions& actions, BrushSettings* brush, Viewport* viewport, Settings* settings, const Say& say);
} // namespace ui
