#include "app/commands/class_results.h"

#include "ui/util/path_display.h"

namespace app
{
namespace
{
using Json = nlohmann::ordered_json;

Json textOrNull(const QString& text)
{
    return text.isEmpty() ? Json(nullptr) : Json(text.toStdString());
}
} // namespace

ClassResults::ClassResults(LessonResults::Form form, const QString& lesson, std::size_t step, const QString& title)
    : m_form(form)
    , m_head{{"format", "fettle-lesson-result"},
             {"version", 1},
             {"lesson", lesson.toStdString()},
             {"step", step + 1},
             {"title", title.toStdString()}}
{}

void ClassResults::add(const FoundModel& model, const core::CheckpointVerdict& verdict, const QString& problem)
{
    const bool isRead = problem.isEmpty();
    Json row = m_head, goals = goalsOf(verdict);
    for (Json& goal : goals)
        if (!isRead)
            goal["measured"] = goal["met"] = nullptr;
    row["model"] = ui::displayName(model.file).toStdString();
    row["pupil"] = textOrNull(model.turn.pupil);
    row["turn_begun"] = textOrNull(model.turn.begun.toString(Qt::ISODate));
    row["met"] = isRead ? Json(verdict.isMet()) : Json(nullptr);
    row["goals"] = goals;
    row["error"] = textOrNull(problem);
    m_rows.push_back(row);
}

/// Returns the CSV text. Each goal has two columns: the measured value, and whether the goal is met.
QString ClassResults::csv() const
{
    Json rows = Json::array();
    for (const Json& result : m_rows) {
        Json row;
        for (const char* key : {"lesson", "step", "title", "model", "pupil", "turn_begun", "met"})
            row[key] = result[key];
        for (const Json& goal : result["goals"]) {
            const auto name = goal["goal"].get<std::string>();
            row[name] = goal["measured"];
            row[name + "_met"] = goal["met"];
        }
        row["error"] = result["error"];
        rows.push_back(row);
    }
    return csvOf(rows);
}

QString ClassResults::text() const
{
    if (m_form == LessonResults::Form::Csv)
        return csv();
    QString lines;
    for (const Json& row : m_rows)
        lines += QString::fromStdString(row.dump(-1, ' ', false, Json::error_handler_t::replace)) + u'\n';
    return lines;
}
} // namespace app
