#pragma once

#include <QHash>
#include <QString>

class QMainWindow;

namespace ui
{
class Actions;
struct ActionInfo;
struct Classroom;

/// Whether that action is there in a class. What asks for files, leads to other programs or to what a teacher has set
/// is not; Quit is, because the window asks for the PIN then, and so is the guide, whose links lead to its own pages.
bool isAllowed(const ActionInfo& row, const Classroom& classroom);

/// Takes all else out of the window, keys included: what is not allowed can be neither seen nor done from now on.
/// Panels that lead to files or printers go, too, and so do the window's context menus; of panels only those are there
/// that are known to be for the hand.
void lockWindow(QMainWindow* window, const Actions& actions, const Classroom& classroom);

/// Which of the switches are on; all but those of VR, which belong to the person in the headset.
QHash<QString, bool> switchesOf(const Actions& actions);
/// As they were.
void setSwitches(const Actions& actions, const QHash<QString, bool>& switches);
} // namespace ui
