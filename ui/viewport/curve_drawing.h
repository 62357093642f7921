#pragma once

#include "ui/viewport/drawn_curve.h"

#include <QWidget>

#include <optional>

class QKeyEvent;
class QSinglePointEvent;

namespace ui
{
class AreaBar;
class ViewHint;
class Viewport;

/// Lets the user draw a closed curve over the view, and tints the side of it that counts: inside or outside, as chosen;
/// the other one while Shift is held. A bar offers the shapes, also by the keys 1 to 4, and the sides (O, F); a hint
/// says what will happen. Esc or the right button cancels. A polygon ends with a double click, Return, or a click on
/// its first corner; Backspace takes back the last corner. Until the curve is begun, the middle button and the wheel
/// still move the view. Drawn over its parent and transparent for the mouse. Thread: gui.
class CurveDrawing : public QWidget
{
    Q_OBJECT

public:
    explicit CurveDrawing(Viewport* viewport);

    /// Waits for a curve of the shape that was used last; instead of the one that was being drawn, if any. No effect
    /// while the view is hidden, a stroke is open or a press is pending.
    void begin(AreaUse use);
    bool isActive() const { return m_use.has_value(); }
    void cancel();

Q_SIGNALS:
    /// The user has closed the curve.
    void drawn(const ui::DrawnArea& area);
    /// The curve has no area, and another one is awaited. `sentence`: the message for the user.
    void refused(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    bool handleKey(const QKeyEvent& event);
    bool handlePointer(const QSinglePointEvent& event);
    void press(const QSinglePointEvent& event);
    void moveTo(const QPointF& position);
    void addCorner(const QPointF& position);
    void close();
    QPolygonF curve() const;
    bool isOutside() const;
    void setShift(bool isHeld);
    void showHint();

    Viewport* m_viewport;
    ViewHint* m_hint;
    AreaBar* m_bar;
    std::optional<AreaUse> m_use; ///< use of the area that is awaited or drawn; nullopt: none
    QPolygonF m_points;           ///< of the pointer, or the corners of a polygon
    QPointF m_pointer;
    bool m_isShiftHeld = false;
    /// the release of the mouse press that ended the curve is still to come, and must be swallowed
    bool m_releaseFollows = false;
};
} // namespace ui
