#pragma once

#include "core/lesson/lesson.h"

#include <QByteArray>
#include <QString>

namespace app
{
/// Returns a PDF of a lesson for pupils: its title, and of each step picture, title and text. A4, or Letter where that
/// is the paper of the locale. Needs a QGuiApplication, whose fonts it uses.
QByteArray lessonHandout(const core::Lesson& lesson, const QString& language);
} // namespace app
