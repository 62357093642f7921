#pragma once

#include "app/classroom/classroom_turn.h"

namespace app
{
/// A file that keeps the present turn across a crash, beside its journal. The journal contains the model; the note
/// contains pupil, time and place in the lesson. If the note cannot be written or read, only these are lost. Thread:
/// gui.
class TurnNote
{
public:
    explicit TurnNote(QString path) : m_path(std::move(path)) {}

    void write(const ClassTurn& turn);
    /// Writes the note again if the turn's place in its lesson has changed.
    void update(const ClassTurn& turn);
    /// Returns the noted turn, ended at the time `interrupted`; nothing if there is no valid note. Its place in the
    /// lesson has the path of the lesson but no lesson.
    std::optional<ClassTurn> read(const QDateTime& interrupted) const;

private:
    QString m_path;
    std::optional<LessonPlace> m_place; ///< the place written last
};
} // namespace app
