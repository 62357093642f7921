#pragma once

#include <QLabel>

#include <optional>

namespace ui
{
struct TurnTime;

/// Large text over a view, readable from the back of a room: the last 60 seconds of a turn, then the time since its
/// end. Lets input through to the view. Thread: gui.
class TurnCountdown : public QLabel
{
    Q_OBJECT

public:
    explicit TurnCountdown(QWidget* over);

    /// nullopt: the turn has no end, or it is nobody's turn; hides the text.
    void setTime(const std::optional<ui::TurnTime>& time);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();
};
} // namespace ui
