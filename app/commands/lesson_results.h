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

    /// `model`: the pupil's; empty: what the teacher's strokes leave.
    LessonResults(Form form, const QString& lesson, const QString& title, const QString& model);

    /// Adds what the checkpoint of a step says. `index`: from 0.
    void add(std::size_t index, const QString& title, const core::LessonStep& step,
             const core::CheckpointVerdict& verdict);
    /// Returns one JSON object in a line, or CSV: a header row, and a row for each goal.
    QString text() const;

private:
    QString csv() const;

    Form m_form;
    nlohmann::ordered_json m_all;
};

/// Returns an object for each goal of a checkpoint: what is asked, what was measured, and whether it is met.
nlohmann::ordered_json goalsOf(const core::CheckpointVerdict& verdict);

/// Returns the rows, objects with the same keys, as CSV with a header row.
QString csvOf(const nlohmann::ordered_json& rows);
} // namespace app
