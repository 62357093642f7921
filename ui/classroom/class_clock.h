#pragma once

#include <QStringList>
#include <QWidget>

#include <optional>

class QLabel;
class QMainWindow;

namespace ui
{
struct TurnTime;

/// A window for the projector: whose turn it is, the remaining time, and the next pupil. Fills a second screen if there
/// is one; otherwise it is a small window in a corner of the view, which can be dragged anywhere. Hidden at first.
/// Thread: gui.
class ClassClock : public QWidget
{
    Q_OBJECT

public:
    /// `names`: pupils in the order of their turns; empty: the next pupil is not shown.
    ClassClock(const QString& title, const QStringList& names, QMainWindow* window);

    void setPupil(const std::optional<QString>& pupil);
    void setTime(const std::optional<ui::TurnTime>& time);
    /// Excludes pupils who have had a turn from being shown as the next pupil.
    void setHadTurn(const QStringList& pupils);
    /// Shows the hidden clock or hides the visible one.
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
    QString m_present; ///< pupil whose turn it is; empty: nobody's turn
    QMainWindow* m_window;
    bool m_isPlaced = false; ///< already placed once; after that the clock stays where the user moved it
    QPoint m_grip;           ///< position in the clock at which the mouse drags it
    QLabel *m_pupil, *m_time, *m_next;
};
} // namespace ui
