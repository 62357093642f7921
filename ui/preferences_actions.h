#pragma once

class QWidget;

namespace ui
{
class Actions;
class Settings;
class Viewport;

/// The stored preferences hold from now on, and Edit > Preferences changes them. The settings must outlive the window.
/// Gui thread.
void connectPreferences(const Actions& actions, Settings* settings, Viewport* viewport, QWidget* window);
} // namespace ui
