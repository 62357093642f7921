#pragma once

#include "app/classroom/class_works.h"
#include "app/commands/lesson_results.h"

namespace app
{
/// The verdicts of one checkpoint on the models of a folder, for scripts: a JSON object in a line, or a row of CSV, for
/// each.
class ClassResults
{
public:
    /// `step`: from 0.
    ClassResults(LessonResults::Form form, const QString& lesson, std::size_t step, const QString& title);

    /// Adds a model. `problem`: a sentence, if it cannot be read; then the verdict says only what was asked.
    void add(const FoundModel& model, const core::CheckpointVerdict& verdict, const QString& problem = {});
    QString text() const;

private:
    QString csv() const;

    LessonResults::Form m_form;
    nlohmann::ordered_json m_head;                                   ///< of each object
    nlohmann::ordered_json m_rows = nlohmann::ordered_json::array(); ///< one for each model
};
} // namespace app
