#pragma once

#include "ui/viewport/drawn_curve.h"

#include <QWidget>

#include <optional>

class QKeyEvent;
class QLabel;
class QSinglePointEvent;

namespace ui
{
class Viewport;

/// Lets the user draw a closed curve over the view, and tints the side of it that counts: inside, or outside while
/// Shift is held. Esc or the right button cancels. A polygon ends with a double click, Return, or a click on its first
/// corner; Backspace takes back the last corner. Until the curve is begun, the middle button and the wheel still move
/// the view. Drawn over its parent and transparent for the mouse. Thread: gui.
class CurveDrawing : public QWidget
{
    Q_OBJECT

public:
    explicit CurveDrawing(Viewport* viewport);

    /// Waits for a curve of this shape; instead of the one that was being drawn, if any. No effect while the view is
    /// hidden, a stroke is open or a press is pending.
    void begin(CurveShape shape);
    bool isActive() const { return m_shape.has_value(); }
    void cancel();

Q_SIGNALS:
    /// The user has closed the curve: its corners in the view, logical pixels. `isOutside`: the outside counts.
    void drawn(const QPolygonF& curve, bool isOutside);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    bool handleKey(const QKeyEvent& event);
    bool handlePointer(const QSinglePointEvent& event);
    void press(const QSinglePointEvent& event);
    void moveTo(const QPointF& position);
    void release();
    void addCorner(const QPointF& position);
    void close();
    QPolygonF curve() const;
    void setOutside(bool isOutside);
    void showHint();

    Viewport* m_viewport;
    QLabel* m_hint;
    std::optional<CurveShape> m_shape; ///< shape that is awaited or drawn; nullopt: none
    QPolygonF m_points;                ///< of the pointer, or the corners of a polygon
    QPointF m_pointer;
    bool m_isOutside = false;
    /// the release of the mouse press that ended the curve is still to come, and must be swallowed
    bool m_releaseFollows = false;
};
} // namespace ui
