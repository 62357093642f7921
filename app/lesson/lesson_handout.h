#pragma once

#include "core/lesson/lesson.h"

#include <QByteArray>
#include <QString>

namespace app
{
/// Returns a handout for pupils as PDF: the lesson's title, then picture, title and text of each step. The paper is A4,
/// or Letter in locales that use it. Precondition: a QGuiApplication exists, because its fonts are used.
QByteArray lessonHandout(const core::Lesson& lesson, const QString& language);
} // namespace app
