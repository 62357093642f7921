#pragma once

class QMainWindow;

namespace ui
{
class Actions;
class Settings;
class StartPage;

/// The Help menu's commands. The start page lies over the window's middle. Actions and settings must outlive the
/// window. Thread: gui.
StartPage* connectHelp(const Actions& actions, Settings* settings, QMainWindow* window);
} // namespace ui
