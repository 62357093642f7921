#pragma once

#include <QLabel>

#include <optional>

namespace ui
{
struct TurnTime;

/// Large words over a view, to be read from the back of a room: the seconds of a turn's last minute, then that its time
/// is up and for how long. Takes no input from the view below. Thread: gui.
class TurnCountdown : public QLabel
{
    Q_OBJECT

public:
    explicit TurnCountdown(QWidget* over);

    /// Takes nothing where the turn has no end, or it is nobody's.
    void setTime(const std::optional<ui::TurnTime>& time);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();
};
} // namespace ui
