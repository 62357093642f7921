#pragma once

#include <QHash>
#include <QString>

class QMainWindow;

namespace ui
{
class Actions;
struct ActionInfo;
struct Classroom;

/// Returns true if the action is available in a class. Actions that open files, other programs or the teacher's
/// settings are not. Quit is available, because it asks for the PIN; the guide is available, because its links stay
/// inside the guide.
bool isAllowed(const ActionInfo& row, const Classroom& classroom);

/// Hides and disables everything in the window that the class does not allow, including keys, context menus, and all
/// panels except those known not to lead to files or printers.
void lockWindow(QMainWindow* window, const Actions& actions, const Classroom& classroom);

/// Returns which checkable actions are on. VR's are excluded, because they belong to the person in the headset.
QHash<QString, bool> switchesOf(const Actions& actions);
/// Restores the states that switchesOf() returned.
void setSwitches(const Actions& actions, const QHash<QString, bool>& switches);
} // namespace ui
