#pragma once

class QMainWindow;

namespace ui
{
class Actions;
class BrushSettings;
class Settings;
class SideColumn;
class Viewport;

/// What preferences are for. The actions and the settings must outlive the window.
struct PreferencesContext
{
    QMainWindow* window;
    SideColumn* column;
    Actions* actions;
    Settings* settings;
    BrushSettings* brush;
    Viewport* viewport;
};

/// The stored preferences hold from now on, and Edit > Preferences changes them. Where the panels are now is where they
/// come back to when all is reset. Thread: gui.
void connectPreferences(const PreferencesContext& context);
} // namespace ui
