#pragma once

class QMainWindow;

namespace ui
{
class Settings;
class SideColumn;

/// Restores the window's position and its panels, or a default size at the first start. Never larger than the screen.
/// Precondition: the window has not been shown yet.
void restoreWindowGeometry(QMainWindow* window, SideColumn* column, const Settings& settings);
void saveWindowGeometry(const QMainWindow& window, const SideColumn& column, Settings& settings);
} // namespace ui
