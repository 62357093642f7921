#pragma once

#include "app/lesson/lesson_place.h"

#include "core/lesson/checkpoint.h"

#include <QCoreApplication>
#include <QJsonObject>

#include <optional>

namespace app
{
/// A turn's progress in a lesson, as stored in turn.json. Thread: any.
class LessonResult
{
    Q_DECLARE_TR_FUNCTIONS(app::LessonResult)

public:
    QString lesson; ///< name of a bundled lesson, or name of the lesson's file
    QString title;  ///< title in the language of the class
    int step = 0;   ///< the step reached, counted from 1
    int steps = 0;
    bool isTeachers = false;         ///< whether the model contains strokes of the lesson's demonstration in this step
    core::CheckpointVerdict verdict; ///< verdict of the step's checkpoint, without distances

    /// Evaluates a model by the checkpoint of the present step.
    static LessonResult of(const LessonPlace& place, const core::TriangleMesh& model);
    QJsonObject toJson() const;
    /// Returns nothing if `json` is not a result. Unknown goals are left out.
    static std::optional<LessonResult> from(const QJsonObject& json);
    /// Returns the result as one line of text.
    QString sentence() const;
};
} // namespace app
