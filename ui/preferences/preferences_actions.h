#pragma once

class QMainWindow;

namespace ui
{
class Actions;
class BrushSettings;
class Settings;
class SideColumn;
class Viewport;

/// The objects that the preferences affect. Precondition: actions and settings outlive the window.
struct PreferencesContext
{
    QMainWindow* window;
    SideColumn* column;
    Actions* actions;
    Settings* settings;
    BrushSettings* brush;
    Viewport* viewport;
};

/// Applies the stored preferences now and connects Edit > Preferences, which changes them. A reset returns bars and
/// panels to their places at the time of this call. Thread: gui.
void connectPreferences(const PreferencesContext& context);
} // namespace ui
