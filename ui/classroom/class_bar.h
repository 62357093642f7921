#pragma once

#include <QToolBar>

#include <optional>

class QLabel;
class QMainWindow;
class QPushButton;

namespace ui
{
/// Remaining time of a turn.
struct TurnTime
{
    int seconds = 0;        ///< remaining seconds; 0: the turn is over
    bool isNearEnd = false; ///< the warning before the end has been given
    int over = 0;           ///< seconds since the end of the turn

    bool operator==(const TurnTime&) const = default;
};
/// Returns whole minutes, rounded up.
inline int minutesOf(int seconds)
{
    return (seconds + 59) / 60;
}

/// Returns minutes and seconds, such as "1:05" for 65 seconds.
QString clockText(int seconds);

/// The tool bar of a class: whose turn it is, the remaining time, and a button for the next pupil. Adds itself to the
/// window as the topmost bar. Thread: gui.
class ClassBar : public QToolBar
{
    Q_OBJECT

public:
    ClassBar(const QString& title, QMainWindow* window);

    /// Shows whose turn it is. nullopt: nobody's, and Next Pupil is disabled.
    void setPupil(const std::optional<QString>& pupil);
    /// Shows the remaining time. nullopt: the turn has no end.
    void setTime(const std::optional<TurnTime>& time);
    /// Offers to resume the turn of the pupil whose turn was just ended; nullopt: there is nothing to resume.
    void setResumable(const std::optional<QString>& pupil);
    /// Shows how many works are still on this computer instead of in the class's folder. `tip`: their folder and the
    /// reason.
    void setUndelivered(int works, const QString& tip);
    /// Disables all buttons while a work is being saved.
    void setBusy(bool isBusy);

Q_SIGNALS:
    void nextRequested();
    void resumeRequested();
    void leaveRequested();
    void clockRequested();
    /// setPupil() was called with `pupil`.
    void pupilShown(const std::optional<QString>& pupil);
    /// setTime() was called with `time`.
    void timeShown(const std::optional<ui::TurnTime>& time);

private:
    QLabel* addLabel(const char* name, QLabel* label);
    void enable();

    QLabel *m_pupil, *m_clock, *m_time, *m_undelivered;
    QPushButton *m_resume, *m_next, *m_leave;
    QAction* m_resumeCell = nullptr;
    bool m_isBusy = false, m_isTurn = false;
};
} // namespace ui
