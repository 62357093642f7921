#pragma once

#include "app/classroom/classroom_turn.h"

#include <functional>

namespace app
{
/// The present turn, and its time. Thread: gui.
class TurnClock
{
public:
    enum class Notice { None, Warning, Over };
    struct Limits
    {
        int turnMinutes = 0;    ///< 0: a turn has no end
        int warningMinutes = 0; ///< before its end
    };

    /// Only differences of `nowMs` count.
    TurnClock(const Limits& limits, std::function<qint64()> nowMs) : m_limits(limits), m_nowMs(std::move(nowMs)) {}

    void start(const ClassTurn& turn);
    /// Nobody's turn.
    void clear() { m_turn = {}; }
    /// The turn with the time that it has used by now.
    ClassTurn turn() const;
    const QString& pupil() const { return m_turn.pupil; }
    bool hasEnd() const { return m_limits.turnMinutes > 0; }
    /// Precondition: it has an end.
    qint64 remainingMs() const;
    /// Returns the time since its end. Precondition: it has an end.
    qint64 overMs() const;
    bool isWarned() const { return m_isWarned; }
    /// Returns each notice once a turn, when it is due.
    Notice takeNotice();

private:
    Limits m_limits;
    std::function<qint64()> m_nowMs;
    ClassTurn m_turn;
    qint64 m_startMs = 0;
    bool m_isWarned = false, m_isOver = false;
};
} // namespace app
