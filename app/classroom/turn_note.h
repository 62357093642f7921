#pragma once

#include "app/classroom/classroom_turn.h"

namespace app
{
/// Note of the present turn that outlives the program, in a file beside its journal: the journal has the model, the
/// note has who, when and where in the lesson. A file that cannot be written or read costs only these. Thread: gui.
class TurnNote
{
public:
    explicit TurnNote(QString path) : m_path(std::move(path)) {}

    void write(const ClassTurn& turn);
    /// Writes it again if the turn is somewhere else in its lesson by now.
    void update(const ClassTurn& turn);
    /// Returns the noted turn as it was when it was interrupted; nothing if there is none. The place in its lesson has
    /// no lesson, only the path of one.
    std::optional<ClassTurn> read(const QDateTime& interrupted) const;

private:
    QString m_path;
    std::optional<LessonPlace> m_place; ///< that was written last
};
} // namespace app
