#include "app/classroom/lesson_result.h"

#include "app/lesson/lesson_messages.h"
#include "app/lesson/lesson_model.h"

#include "core/lesson/lesson_playback.h"
#include "ui/util/path_display.h"

#include <QJsonArray>

#include <algorithm>

namespace app
{
namespace
{
const QString lessonKey = QStringLiteral("lesson"), titleKey = QStringLiteral("title"),
              stepKey = QStringLiteral("step"), stepsKey = QStringLiteral("steps"),
              teachersKey = QStringLiteral("teachers_model"), goalsKey = QStringLiteral("goals"),
              goalKey = QStringLiteral("goal"), minKey = QStringLiteral("least"), maxKey = QStringLiteral("most"),
              measuredKey = QStringLiteral("measured"), metKey = QStringLiteral("met"),
              distance = QStringLiteral("distance_mm");

QJsonValue boundOf(double value)
{
    return value == core::FactBounds::unbounded ? QJsonValue() : QJsonValue(value);
}

void read(const QJsonObject& goal, core::CheckpointVerdict& verdict)
{
    const QString name = goal.value(goalKey).toString();
    const QJsonValue measured = goal.value(measuredKey);
    const double least = goal.value(minKey).toDouble(), most = goal.value(maxKey).toDouble(core::FactBounds::unbounded);
    const bool holds = goal.value(metKey).toBool();
    if (name == distance) {
        verdict.target.emplace();
        verdict.target->tolerance = most;
        verdict.target->nearDistance = measured.toDouble();
        verdict.target->holds = holds;
        return;
    }
    const auto* const found = std::ranges::find(core::factTable, name.toStdString(), &core::FactInfo::key);
    if (found != std::end(core::factTable))
        verdict.facts.push_back({{static_cast<core::Fact>(found - core::factTable), least, most},
                                 measured.isDouble() ? std::optional(measured.toDouble()) : std::nullopt,
                                 holds});
}

QString marked(bool holds, const QString& goal)
{
    return QStringLiteral("%1 %2").arg(holds ? QStringLiteral("✓") : QStringLiteral("○"), goal);
}
} // namespace

LessonResult LessonResult::of(const LessonPlace& place, const core::TriangleMesh& model)
{
    LessonResult result;
    result.lesson = ui::displayName(place.path.filename());
    result.title = inOurLanguage(place.lesson->title);
    result.step = static_cast<int>(place.step) + 1;
    result.steps = static_cast<int>(place.lesson->steps.size());
    result.isTeachers = place.isTeachers;
    const core::Checkpoint& checkpoint = place.lesson->steps[place.step].checkpoint;
    core::TriangleMesh target;
    if (checkpoint.target) {
        core::LessonPlayback playback(place.lesson, place.path);
        try {
            playback.goTo(place.step);
            target = playback.target();
        } catch (const core::LessonError&) { // if the step cannot be played, there is no target to compare with
            return result;
        }
    }
    result.verdict = core::evaluate(checkpoint, model, checkpoint.target ? &target : nullptr);
    if (result.verdict.target)
        result.verdict.target->distances.clear();
    return result;
}

QJsonObject LessonResult::toJson() const
{
    QJsonArray goals;
    for (const core::FactVerdict& fact : verdict.facts)
        goals.append(QJsonObject{{goalKey, QString::fromUtf8(core::info(fact.asked.fact).key)},
                                 {minKey, boundOf(fact.asked.min)},
                                 {maxKey, boundOf(fact.asked.max)},
                                 {measuredKey, fact.measured ? QJsonValue(*fact.measured) : QJsonValue()},
                                 {metKey, fact.holds}});
    if (verdict.target)
        goals.append(QJsonObject{{goalKey, distance},
                                 {minKey, 0},
                                 {maxKey, verdict.target->tolerance},
                                 {measuredKey, verdict.target->nearDistance},
                                 {metKey, verdict.target->holds}});
    return {{lessonKey, lesson}, {titleKey, title},         {stepKey, step},
            {stepsKey, steps},   {teachersKey, isTeachers}, {goalsKey, goals}};
}

std::optional<LessonResult> LessonResult::from(const QJsonObject& json)
{
    LessonResult result;
    result.lesson = json.value(lessonKey).toString();
    result.title = json.value(titleKey).toString(result.lesson);
    result.step = json.value(stepKey).toInt();
    result.steps = json.value(stepsKey).toInt();
    result.isTeachers = json.value(teachersKey).toBool();
    for (const QJsonValue& goal : json.value(goalsKey).toArray())
        read(goal.toObject(), result.verdict);
    return result.lesson.isEmpty() ? std::nullopt : std::optional(result);
}

QString LessonResult::sentence() const
{
    QStringList parts{tr("Lesson %1: step %2 of %3").arg(title).arg(step).arg(steps)};
    if (isTeachers)
        parts << tr("this is the teacher's model");
    for (const core::FactVerdict& fact : verdict.facts)
        parts << marked(fact.holds, LessonMessages::goal(fact));
    if (verdict.target)
        parts << marked(verdict.target->holds, LessonMessages::goal(*verdict.target));
    return parts.join(QStringLiteral(" · "));
}
} // namespace app
