#pragma once

#include <QToolBar>

#include <optional>

class QLabel;
class QMainWindow;
class QPushButton;

namespace ui
{
/// How much of a turn is left.
struct TurnTime
{
    int seconds = 0;        ///< 0: it is over
    bool isNearEnd = false; ///< the warning has been given
    int over = 0;           ///< seconds since the end

    bool operator==(const TurnTime&) const = default;
};
/// What is left is never told as less than it is.
inline int minutesOf(int seconds)
{
    return (seconds + 59) / 60;
}

/// Returns "1:05" of 65 seconds.
QString clockText(int seconds);

/// The topmost bar of a class: whose turn it is, how long it lasts, and whose comes next. Shows itself in the window.
/// Thread: gui.
class ClassBar : public QToolBar
{
    Q_OBJECT

public:
    ClassBar(const QString& title, QMainWindow* window);

    /// Nothing: it is nobody's turn, and Next Pupil is disabled.
    void setPupil(const std::optional<QString>& pupil);
    /// Nothing: the turn has no end.
    void setTime(const std::optional<TurnTime>& time);
    /// Whose turn was ended by the last press and may go on; nothing: nobody's.
    void setResumable(const std::optional<QString>& pupil);
    /// Shows how many works are on this computer and not yet in the class's folder; `tip`: where, and why.
    void setUndelivered(int works, const QString& tip);
    /// A work is being saved: all buttons are disabled.
    void setBusy(bool isBusy);

Q_SIGNALS:
    void nextRequested();
    void resumeRequested();
    void leaveRequested();
    void clockRequested();
    /// Emitted with what setPupil() was told.
    void pupilShown(const std::optional<QString>& pupil);
    /// As setTime() was told.
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
