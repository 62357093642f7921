#pragma once

#include <QString>

class QDockWidget;
class QMainWindow;
class QMenu;

namespace ui
{
/// Puts the dock at the window's right, with an entry in `toggles` that shows and hides it: as a tab behind the dock of
/// that object name, or below the others. Gui thread.
void addSideDock(QMainWindow* window, QMenu* toggles, QDockWidget* dock, const QString& behind = {});
} // namespace ui
