#pragma once

#include <QStringList>
#include <QWidget>

#include <optional>

class QLabel;

namespace ui
{
struct TurnTime;

/// A window for the projector: whose turn it is, how long it lasts, and who comes next. It fills another screen where
/// there is one. Hidden at first. Thread: gui.
class ClassClock : public QWidget
{
    Q_OBJECT

public:
    /// `names`: of the pupils, in their order; none: nobody knows who comes next.
    ClassClock(const QString& title, const QStringList& names, QWidget* window);

    void setPupil(const std::optional<QString>& pupil);
    void setTime(const std::optional<ui::TurnTime>& time);
    /// Leaves out those who have had a turn.
    void setHadTurn(const QStringList& pupils);
    /// Shows it, or hides it if it is there.
    void toggle();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showNext();

    QStringList m_names, m_hadTurn;
    QString m_present; ///< pupil; empty: nobody's turn
    QLabel *m_pupil, *m_time, *m_next;
};
} // namespace ui
