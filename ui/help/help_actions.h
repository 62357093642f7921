#pragma once

class QMainWindow;

namespace ui
{
class Actions;
class Settings;
class StartPage;

/// Connects the actions of the Help menu and creates the start page, which covers the middle of the window.
/// Precondition: `actions` and `settings` outlive the window. Thread: gui.
StartPage* connectHelp(const Actions& actions, Settings* settings, QMainWindow* window);
} // namespace ui
