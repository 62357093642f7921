#pragma once

#include "ui/classroom/classroom.h"

#include <functional>

class QWidget;

namespace ui
{
class Actions;

/// What a teacher typed: the class without its PIN, the PIN, and the file that it is to be kept in.
struct ClassroomDraft
{
    Classroom classroom;
    QString pin;
    QString path;
};

/// Asks what a class may do, then where to keep it. Returns at once; `callback` is called when both are agreed.
/// `folder`: where the dialogs for files begin.
void askForClassroom(QWidget* parent, const Actions& actions, const QString& folder,
                     const std::function<void(const ClassroomDraft&)>& callback);
} // namespace ui
