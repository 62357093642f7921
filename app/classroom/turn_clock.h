#pragma once

#include "app/classroom/classroom_turn.h"

#include <functional>

namespace app
{
/// The present turn and its clock. Thread: gui.
class TurnClock
{
public:
    enum class Notice { None, Warning, Over };
    struct Limits
    {
        int turnMinutes = 0;    ///< 0: unlimited
        int warningMinutes = 0; ///< time before the end at which the pupil is warned
    };

    /// `nowMs`: a clock, of which only differences are used.
    TurnClock(const Limits& limits, std::function<qint64()> nowMs) : m_limits(limits), m_nowMs(std::move(nowMs)) {}

    void start(const ClassTurn& turn);
    /// Ends the turn: it is nobody's turn.
    void clear() { m_turn = {}; }
    /// Returns the turn, with the time used until now.
    ClassTurn turn() const;
    const QString& pupil() const { return m_turn.pupil; }
    bool hasEnd() const { return m_limits.turnMinutes > 0; }
    /// Returns the time left, 0 if the time is up. Precondition: hasEnd().
    qint64 remainingMs() const;
    /// Returns the time since the end of the turn, 0 before it. Precondition: hasEnd().
    qint64 overMs() const;
    bool isWarned() const { return m_isWarned; }
    /// Returns the notice that is due now, or None. Each notice is returned once per turn.
    Notice takeNotice();

private:
    Limits m_limits;
    std::function<qint64()> m_nowMs;
    ClassTurn m_turn;
    qint64 m_startMs = 0;
    bool m_isWarned = false, m_isOver = false;
};
} // namespace app
