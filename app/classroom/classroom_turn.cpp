#include "app/classroom/classroom_turn.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

namespace app
{
namespace
{
const QString idKey = QStringLiteral("id"), nameKey = QStringLiteral("name"), begunKey = QStringLiteral("begun"),
              resumedKey = QStringLiteral("resumed");
} // namespace

TurnRecord joined(const TurnRecord& before, const TurnRecord& after)
{
    if (!before || !after)
        return std::nullopt;
    std::vector<core::FileEntry> both = *before;
    both.insert(both.end(), after->begin(), after->end());
    return both;
}

void writeTurnNote(const QString& path, const ClassTurn& turn)
{
    QDir().mkpath(QFileInfo(path).absolutePath());
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return;
    file.write(QJsonDocument(QJsonObject{{idKey, turn.id},
                                         {nameKey, turn.pupil},
                                         {begunKey, turn.begun.toString(Qt::ISODate)},
                                         {resumedKey, turn.isResumed}})
                   .toJson());
    file.commit();
}

std::optional<ClassTurn> readTurnNote(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QJsonObject note = QJsonDocument::fromJson(file.readAll()).object();
    const ClassTurn turn{note.value(idKey).toString(),
                         note.value(nameKey).toString(),
                         QDateTime::fromString(note.value(begunKey).toString(), Qt::ISODate),
                         0,
                         {},
                         note.value(resumedKey).toBool()};
    return turn.id.isEmpty() || !turn.begun.isValid() ? std::nullopt : std::optional(turn);
}
} // namespace app
