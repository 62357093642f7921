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
    /// Says a goal and what the model has, in a child's words: "at least 60 mm tall (now 42.5 mm)".
    static QString goal(const core::FactVerdict& verdict);
    static QString goal(const core::TargetVerdict& verdict);
    /// Says a goal alone.
    static QString asked(const core::FactBounds& bounds);
    static QString asked(const core::CheckpointTarget& target);
    /// Says the goal of a step with strokes that its facts do not say.
    static QString sculpted();

    static QString tool(core::Tool tool);
    /// Says a tool and its size: "Pull 42 mm", or "Pull 42 mm (strength 0.7)".
    static QString brush(const core::LessonBrush& brush);

private:
    static QString place(const core::LessonError& error);
    static QString reason(const core::LessonError& error);
    static QString json(const core::LessonError& error);
    static QString wrongType(const std::string& key);
    static QString files(const core::LessonError& error);
    static QString figure(core::Fact fact, double value);
    static QString quantity(const core::FactBounds& bounds);
};
} // namespace app
