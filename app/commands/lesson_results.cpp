#include "app/commands/lesson_results.h"

#include "app/commands/text_table.h"

#include <cmath>
#include <string>

namespace app
{
namespace
{
using Json = nlohmann::ordered_json;

/// Returns a bound or measured value; counts are written as integers.
Json figureOf(core::Fact fact, double value)
{
    if (value == core::FactBounds::unbounded)
        return nullptr;
    return core::info(fact).isWhole ? Json(std::llround(value)) : Json(value);
}

Json toJson(const core::FactVerdict& fact)
{
    return {{"goal", core::info(fact.asked.fact).key},
            {"least", figureOf(fact.asked.fact, fact.asked.min)},
            {"most", figureOf(fact.asked.fact, fact.asked.max)},
            {"measured", fact.measured ? figureOf(fact.asked.fact, *fact.measured) : Json(nullptr)},
            {"met", fact.holds}};
}

Json toJson(const core::TargetVerdict& target)
{
    return {{"goal", "distance_mm"},
            {"least", 0.0},
            {"most", target.tolerance},
            {"measured", target.nearDistance},
            {"met", target.holds}};
}

QString fieldOf(const Json& value)
{
    if (value.is_null())
        return {};
    return value.is_string() ? csvField(QString::fromStdString(value.get<std::string>()))
                             : QString::fromStdString(value.dump());
}
} // namespace

LessonResults::LessonResults(Form form, const QString& lesson, const QString& title, const QString& model)
    : m_form(form)
    , m_all{{"format", "fettle-lesson-results"},
            {"version", 1},
            {"lesson", lesson.toStdString()},
            {"title", title.toStdString()},
            {"model", model.isEmpty() ? Json(nullptr) : Json(model.toStdString())},
            {"met", true},
            {"steps", Json::array()}}
{}

void LessonResults::add(std::size_t index, const QString& title, const core::LessonStep& step,
                        const core::CheckpointVerdict& verdict)
{
    Json tools = Json::array();
    for (const core::Tool tool : step.tools)
        tools.push_back(core::name(tool));
    m_all["met"] = m_all["met"].get<bool>() && verdict.isMet();
    m_all["steps"].push_back({{"step", index + 1},
                              {"title", title.toStdString()},
                              {"strokes", step.strokes.size()},
                              {"tools", tools},
                              {"met", verdict.isMet()},
                              {"goals", goalsOf(verdict)}});
}

QString LessonResults::csv() const
{
    Json rows = Json::array();
    for (const Json& step : m_all["steps"])
        for (const Json& goal : step["goals"]) {
            Json row{{"lesson", m_all["lesson"]},
                     {"model", m_all["model"]},
                     {"step", step["step"]},
                     {"title", step["title"]}};
            row.update(goal);
            rows.push_back(row);
        }
    return csvOf(rows);
}

QString LessonResults::text() const
{
    if (m_form == Form::Csv)
        return csv();
    return QString::fromStdString(m_all.dump(-1, ' ', false, Json::error_handler_t::replace)) + u'\n';
}

Json goalsOf(const core::CheckpointVerdict& verdict)
{
    Json goals = Json::array();
    for (const core::FactVerdict& fact : verdict.facts)
        goals.push_back(toJson(fact));
    if (verdict.target)
        goals.push_back(toJson(*verdict.target));
    return goals;
}

QString csvOf(const Json& rows)
{
    QString text;
    QStringList names;
    for (const Json& row : rows) {
        QStringList fields;
        const bool isFirst = names.isEmpty();
        for (const auto& [key, value] : row.items()) {
            fields << fieldOf(value);
            if (isFirst)
                names << QString::fromStdString(key);
        }
        text += (isFirst ? names.join(u',') + u'\n' : QString()) + fields.join(u',') + u'\n';
    }
    return text;
}
} // namespace app
