#include "ui/viewport/turntable.h"

#include <algorithm>
#include <chrono>
#include <numbers>
#include <utility>

namespace ui
{
namespace
{
constexpr std::chrono::milliseconds interval(16); ///< about one frame
/// longest step, seconds, so that the model does not jump after the window was blocked
constexpr double maxStepSeconds = 0.1;
} // namespace

Turntable::Turntable(QObject* parent) : QObject(parent)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(interval);
    connect(&m_timer, &QTimer::timeout, this, &Turntable::step);
}

void Turntable::setOn(bool on)
{
    if (on == isOn())
        return;
    m_sinceStep.start();
    on ? m_timer.start() : m_timer.stop();
    Q_EMIT changed();
}

void Turntable::setSpeed(double speed)
{
    const double legal = std::clamp(speed, minTurn, maxTurn);
    if (std::exchange(m_speed, legal) != legal)
        Q_EMIT changed();
}

void Turntable::setClockwise(bool clockwise)
{
    if (std::exchange(m_isClockwise, clockwise) != clockwise)
        Q_EMIT changed();
}

void Turntable::step()
{
    const double seconds = std::min(static_cast<double>(m_sinceStep.nsecsElapsed()) * 1e-9, maxStepSeconds);
    m_sinceStep.start();
    Q_EMIT turned((m_isClockwise ? -1 : 1) * m_speed * seconds * std::numbers::pi / 180, seconds);
}
} // namespace ui
