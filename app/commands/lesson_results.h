#pragma once

#include "core/lesson/lesson.h"

#include <QString>

#include <nlohmann/json.hpp>

namespace app
{
/// The verdicts of a lesson's checkpoints on a model, for scripts.
class LessonResults
{
public:
    enum class Form { Json, Csv };

    /// `model`: file of the pupil's model; empty: the result of the teacher's strokes.
    LessonResults(Form form, const QString& lesson, const QString& title, const QString& model);

    /// Adds the verdict of a step. `index`: step index, from 0.
    void add(std::size_t index, const QString& title, const core::LessonStep& step,
             const core::CheckpointVerdict& verdict);
    /// Returns one JSON object on one line, or CSV with a header row and a row for each goal.
    QString text() const;

private:
    QString csv() const;

    Form m_form;
    nlohmann::ordered_json m_all;
};

/// Returns an object for each goal of a checkpoint: the bounds, the measured value, and whether the goal is met.
nlohmann::ordered_json goalsOf(const core::CheckpointVerdict& verdict);

/// Returns the rows as CSV with a header row. Precondition: all rows have the same keys.
QString csvOf(const nlohmann::ordered_json& rows);
} // namespace app
