#pragma once

#include <QString>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QWidget;

namespace ui
{
/// Puts the dock at the window's right, with an entry in `toggles` that shows and hides it: as a tab behind the dock of
/// that object name, or below the others. Thread: gui.
void addSideDock(QMainWindow* window, QMenu* toggles, QDockWidget* dock, const QString& behind = {});
/// A dock of that name and title behind the brush's, with the content, which it takes.
QDockWidget* addSideDock(QMainWindow* window, QMenu* toggles, const QString& name, const QString& title,
                         QWidget* content);
/// Hides the dock until the action brings it to the front.
void showBy(const QAction* action, QDockWidget* dock);
} // namespace ui
