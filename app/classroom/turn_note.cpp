#include "app/classroom/turn_note.h"

#include "app/model/model_loader.h"

#include "ui/util/path_display.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

#include <algorithm>
#include <tuple>

namespace app
{
namespace
{
const QString idKey = QStringLiteral("id"), nameKey = QStringLiteral("name"), begunKey = QStringLiteral("begun"),
              resumedKey = QStringLiteral("resumed"), usedKey = QStringLiteral("used_ms"),
              notedKey = QStringLiteral("noted"), notedLessonKey = QStringLiteral("lesson"),
              notedStepKey = QStringLiteral("step"), notedTeachersKey = QStringLiteral("teachers_model");

bool isSame(const std::optional<LessonPlace>& a, const std::optional<LessonPlace>& b)
{
    const auto parts = [](const LessonPlace& place) { return std::tie(place.path, place.step, place.isTeachers); };
    return a && b ? parts(*a) == parts(*b) : a.has_value() == b.has_value();
}

std::optional<LessonPlace> placeIn(const QJsonObject& note)
{
    const QString path = note.value(notedLessonKey).toString();
    const int step = note.value(notedStepKey).toInt(-1);
    if (path.isEmpty() || step < 0)
        return std::nullopt;
    return LessonPlace{nullptr, toPath(path), static_cast<std::size_t>(step), note.value(notedTeachersKey).toBool()};
}
} // namespace

void TurnNote::write(const ClassTurn& turn)
{
    m_place = turn.lesson;
    QJsonObject note{{idKey, turn.id},
                     {nameKey, turn.pupil},
                     {begunKey, turn.begun.toString(Qt::ISODate)},
                     {resumedKey, turn.isResumed},
                     {usedKey, turn.usedMs},
                     {notedKey, QDateTime::currentDateTime().toString(Qt::ISODateWithMs)}};
    if (m_place) {
        note.insert(notedLessonKey, ui::displayName(m_place->path));
        note.insert(notedStepKey, static_cast<int>(m_place->step));
        note.insert(notedTeachersKey, m_place->isTeachers);
    }
    QDir().mkpath(QFileInfo(m_path).absolutePath());
    QSaveFile file(m_path);
    if (!file.open(QIODevice::WriteOnly))
        return;
    file.write(QJsonDocument(note).toJson());
    file.commit();
}

void TurnNote::update(const ClassTurn& turn)
{
    if (!isSame(turn.lesson, m_place))
        write(turn);
}

/// Notes of older versions have no used time: for them, it is counted from the beginning of the turn.
std::optional<ClassTurn> TurnNote::read(const QDateTime& interrupted) const
{
    QFile file(m_path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QJsonObject note = QJsonDocument::fromJson(file.readAll()).object();
    const auto time = [&note](const QString& key) {
        return QDateTime::fromString(note.value(key).toString(), Qt::ISODateWithMs);
    };
    ClassTurn turn;
    turn.id = note.value(idKey).toString();
    turn.pupil = note.value(nameKey).toString();
    turn.begun = time(begunKey);
    turn.isResumed = note.value(resumedKey).toBool();
    turn.lesson = placeIn(note);
    if (turn.id.isEmpty() || !turn.begun.isValid())
        return {};
    const QDateTime noted = time(notedKey);
    const qint64 since = (noted.isValid() ? noted : turn.begun).msecsTo(interrupted);
    turn.usedMs = note.value(usedKey).toInteger() + std::max<qint64>(since, 0);
    turn.ended = interrupted;
    return turn;
}
} // namespace app
