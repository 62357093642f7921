#pragma once

#include "core/stroke_file.h"

#include <QDateTime>
#include <QString>

#include <optional>
#include <vector>

namespace app
{
/// What the hands did to a starter, in step with an undo stack.
class TurnRecord
{
public:
    TurnRecord() = default;
    /// Goes on from what was done before the stack began; nothing: that is not known.
    explicit TurnRecord(std::optional<std::vector<core::FileEntry>> before)
        : m_isWhole(before.has_value()), m_entries(std::move(before).value_or(std::vector<core::FileEntry>())), m_before(m_entries.size())
    {
    }

    /// The step that makes the stack so long; those that had been undone are gone.
    void add(int steps, core::FileEntry entry);
    /// The stack was cleared though the model stayed: what was done is not known any more.
    void lose() { m_isWhole = false; }

    /// Up to that step; nothing if it is not known.
    std::optional<std::vector<core::FileEntry>> upTo(int step) const;

private:
    bool m_isWhole = true;
    std::vector<core::FileEntry> m_entries;
    std::size_t m_before = 0;
};

/// Whose turn it is.
struct ClassTurn
{
    QString id;
    QString pupil;
    QDateTime begun;
    qint64 usedMs = 0; ///< before it was interrupted
    QDateTime ended = {}; ///< invalid: it goes on
};

/// What of a turn must outlive the program, beside its journal. A file that cannot be written or read only costs the time of its beginning.
void writeTurnNote(const QString& path, const ClassTurn& turn);
std::optional<ClassTurn> readTurnNote(const QString& path);
} // namespace app
