#pragma once

namespace ui
{
class Actions;
class BrushSettings;
class Settings;
class Viewport;

/// The commands that change what the hand does next in the view: values by moving the pointer, the steady stroke. What is to be
/// remembered is taken from the settings now and written there when it changes. None is owned.
void connectHand(const Actions& actions, BrushSettings* brush, Viewport* viewport, Settings* settings);
} // namespace ui
