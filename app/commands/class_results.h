#pragma once

#include "app/classroom/class_works.h"
#include "app/commands/lesson_results.h"

namespace app
{
/// The verdicts of one checkpoint on the models of a folder, for scripts. Each model gets a JSON object on its own
/// line, or a row of CSV.
class ClassResults
{
public:
    /// `step`: step index, from 0.
    ClassResults(LessonResults::Form form, const QString& lesson, std::size_t step, const QString& title);

    /// Adds a model. `problem`: one sentence if the model cannot be read; the verdict then contains only the goals.
    void add(const FoundModel& model, const core::CheckpointVerdict& verdict, const QString& problem = {});
    QString text() const;

private:
    QString csv() const;

    LessonResults::Form m_form;
    nlohmann::ordered_json m_head;                                   ///< keys and values that begin each object
    nlohmann::ordered_json m_rows = nlohmann::ordered_json::array(); ///< one object for each model
};
} // namespace app
