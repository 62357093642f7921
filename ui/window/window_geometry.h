#pragma once

class QMainWindow;

namespace ui
{
class Settings;
class SideColumn;

/// Where the window stands, and its panels within it, as they were kept; the first time in a size of our own. Never
/// larger than the screen. Before the window is shown.
void restoreWindowGeometry(QMainWindow* window, SideColumn* column, const Settings& settings);
void saveWindowGeometry(const QMainWindow& window, const SideColumn& column, Settings& settings);
} // namespace ui
