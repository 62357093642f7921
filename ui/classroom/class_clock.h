#pragma once

#include <QStringList>
#include <QWidget>

#include <optional>

class QLabel;
class QMainWindow;

namespace ui
{
struct TurnTime;

/// A window for the projector: whose turn it is, how long it lasts, and who comes next. It fills another screen where
/// there is one; else it is small and stands in a corner of the view, and any place of it moves it. Hidden at first.
/// Thread: gui.
class ClassClock : public QWidget
{
    Q_OBJECT

public:
    /// `names`: of the pupils, in their order; none: nobody knows who comes next.
    ClassClock(const QString& title, const QStringList& names, QMainWindow* window);

    void setPupil(const std::optional<QString>& pupil);
    void setTime(const std::optional<ui::TurnTime>& time);
    /// Leaves out those who have had a turn.
    void setHadTurn(const QStringList& pupils);
    /// Shows it, or hides it if it is there.
    void toggle();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    void showNext();
    void placeInView();
    void fit();

    QStringList m_names, m_hadTurn;
    QString m_present; ///< pupil; empty: nobody's turn
    QMainWindow* m_window;
    bool m_isPlaced = false; ///< then it stays where it was moved to
    QPoint m_grip;           ///< place of it that is held
    QLabel *m_pupil, *m_time, *m_next;
};
} // namespace ui
