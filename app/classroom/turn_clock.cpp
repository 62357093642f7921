#include "app/classroom/turn_clock.h"

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
constexpr qint64 msPerMinute = 60'000;
} // namespace

void TurnClock::start(const ClassTurn& turn)
{
    m_turn = turn;
    m_startMs = m_nowMs();
    m_isWarned = m_isOver = false;
}

ClassTurn TurnClock::turn() const
{
    ClassTurn turn = m_turn;
    turn.usedMs += m_nowMs() - m_startMs;
    return turn;
}

qint64 TurnClock::remainingMs() const
{
    return std::max<qint64>(m_limits.turnMinutes * msPerMinute - turn().usedMs, 0);
}

qint64 TurnClock::overMs() const
{
    return std::max<qint64>(turn().usedMs - m_limits.turnMinutes * msPerMinute, 0);
}

TurnClock::Notice TurnClock::takeNotice()
{
    const qint64 left = remainingMs();
    if (left == 0 && !std::exchange(m_isOver, true)) {
        m_isWarned = true;
        return Notice::Over;
    }
    if (left <= m_limits.warningMinutes * msPerMinute && !std::exchange(m_isWarned, true))
        return Notice::Warning;
    return Notice::None;
}
} // namespace app
