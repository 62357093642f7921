#pragma once

#include "core/lesson/lesson_file.h"

#include <QCoreApplication>
#include <QString>

namespace app
{
/// Lessons in words for people.
class LessonMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::LessonMessages)

public:
    /// What is wrong with a lesson: one sentence with file, place and reason.
    static QString sentence(const core::LessonError& error);
    /// What a checkpoint asks: "height: at least 60 mm".
    static QString asked(const core::FactBounds& bounds);
    static QString asked(const core::CheckpointTarget& target);
    /// What the model has: "77.5 mm".
    static QString found(const core::FactVerdict& verdict);
    static QString found(const core::TargetVerdict& verdict);

private:
    static QString place(const core::LessonError& error);
    static QString reason(const core::LessonError& error);
    static QString json(const core::LessonError& error);
    static QString files(const core::LessonError& error);
    static QString name(core::Fact fact);
    static QString figure(core::Fact fact, double value);
};
} // namespace app
