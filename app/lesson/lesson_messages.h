#pragma once

#include "core/lesson/lesson_file.h"

#include <QCoreApplication>
#include <QString>

namespace app
{
/// Translated texts about lessons.
class LessonMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::LessonMessages)

public:
    /// Returns one sentence about an error in a lesson: file, place and reason.
    static QString sentence(const core::LessonError& error);
    /// Returns a goal with the measured value, in words for children: "at least 60 mm tall (now 42.5 mm)".
    static QString goal(const core::FactVerdict& verdict);
    static QString goal(const core::TargetVerdict& verdict);
    /// Returns a goal without a measured value.
    static QString asked(const core::FactBounds& bounds);
    static QString asked(const core::CheckpointTarget& target);
    /// Returns the goal that something was sculpted, for a step with strokes.
    static QString sculpted();

    static QString tool(core::Tool tool);
    /// Returns a tool and its radius: "Pull 42 mm", or "Pull 42 mm (strength 0.7)".
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
