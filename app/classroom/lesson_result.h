#pragma once

#include "app/lesson/lesson_place.h"

#include "core/lesson/checkpoint.h"

#include <QCoreApplication>
#include <QJsonObject>

#include <optional>

namespace app
{
/// Progress of a turn in a lesson, which turn.json keeps. Any thread.
class LessonResult
{
    Q_DECLARE_TR_FUNCTIONS(app::LessonResult)

public:
    QString lesson; ///< one of ours, or the name of its file
    QString title;  ///< in the language of the class
    int step = 0;   ///< from 1
    int steps = 0;
    bool isTeachers = false;         ///< the model has strokes of the teacher's in this step
    core::CheckpointVerdict verdict; ///< without distances

    /// Judges a model by the checkpoint of the step.
    static LessonResult of(const LessonPlace& place, const core::TriangleMesh& model);
    QJsonObject toJson() const;
    /// Returns nothing if this is no result, and leaves out goals that are not known.
    static std::optional<LessonResult> from(const QJsonObject& json);
    /// Says it on one line.
    QString sentence() const;
};
} // namespace app
