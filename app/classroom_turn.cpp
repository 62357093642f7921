#include "classroom_turn.h"

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
const QString idKey = QStringLiteral("id"), nameKey = QStringLiteral("name"), begunKey = QStringLiteral("begun");
} // namespace

void TurnRecord::add(int steps, core::FileEntry entry)
{
    m_entries.erase(m_entries.begin() + std::min<std::ptrdiff_t>(std::ssize(m_entries), static_cast<std::ptrdiff_t>(m_before) + steps - 1), m_entries.end());
    m_entries.push_back(std::move(entry));
}

std::optional<std::vector<core::FileEntry>> TurnRecord::upTo(int step) const
{
    const std::size_t count = m_before + static_cast<std::size_t>(step);
    if (!m_isWhole || count > m_entries.size())
        return {};
    return std::vector(m_entries.begin(), m_entries.begin() + static_cast<std::ptrdiff_t>(count));
}

void writeTurnNote(const QString& path, const ClassTurn& turn)
{
    QDir().mkpath(QFileInfo(path).absolutePath());
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return;
    file.write(QJsonDocument(QJsonObject{{idKey, turn.id}, {nameKey, turn.pupil}, {begunKey, turn.begun.toString(Qt::ISODate)}}).toJson());
    file.commit();
}

std::optional<ClassTurn> readTurnNote(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QJsonObject note = QJsonDocument::fromJson(file.readAll()).object();
    const ClassTurn turn{note.value(idKey).toString(), note.value(nameKey).toString(), QDateTime::fromString(note.value(begunKey).toString(), Qt::ISODate), 0};
    return turn.id.isEmpty() || !turn.begun.isValid() ? std::nullopt : std::optional(turn);
}
} // namespace app
