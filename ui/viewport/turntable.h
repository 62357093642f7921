#pragma once

#include "ui/settings/turntable_settings.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace ui
{
/// Turns the model about the Y axis in small timed steps while it is on. Thread: gui.
class Turntable : public QObject
{
    Q_OBJECT

public:
    explicit Turntable(QObject* parent = nullptr);

    bool isOn() const { return m_timer.isActive(); }
    void setOn(bool on);
    /// Returns the speed in degrees per second, which is clamped to [minTurn, maxTurn].
    double speed() const { return m_speed; }
    void setSpeed(double speed);
    /// Returns true if the model turns clockwise, seen from above.
    bool isClockwise() const { return m_isClockwise; }
    void setClockwise(bool clockwise);

Q_SIGNALS:
    void changed();
    /// The model should turn by `angle` radians about the Y axis, its turn during the last `seconds`. Positive angles
    /// are anticlockwise, seen from above.
    void turned(double angle, double seconds);

private:
    void step();

    QTimer m_timer;
    QElapsedTimer m_sinceStep;
    double m_speed = defaultTurn;
    bool m_isClockwise = false;
};
} // namespace ui
