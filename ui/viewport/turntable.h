#pragma once

#include "ui/settings/turntable_settings.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace ui
{
/// Turns the model under the pointer while it is on, by small timed steps. Thread: gui.
class Turntable : public QObject
{
    Q_OBJECT

public:
    explicit Turntable(QObject* parent = nullptr);

    bool isOn() const { return m_timer.isActive(); }
    void setOn(bool on);
    /// In degrees a second, clamped to minTurn to maxTurn.
    double speed() const { return m_speed; }
    void setSpeed(double speed);
    /// Seen from above.
    bool isClockwise() const { return m_isClockwise; }
    void setClockwise(bool clockwise);

Q_SIGNALS:
    void changed();
    /// By so many radians, anticlockwise seen from above, in so many seconds.
    void turned(double angle, double seconds);

private:
    void step();

    QTimer m_timer;
    QElapsedTimer m_sinceStep;
    double m_speed = defaultTurn;
    bool m_isClockwise = false;
};
} // namespace ui
