#pragma once

#include "core/geometry/geometry.h"

#include <QWidget>

namespace ui
{
/// A colour wheel: hue on a ring, and within it a square for saturation (to the right) and value (upwards). Drag in
/// ring or square; the arrow keys move in the square, Page Up and Page Down along the ring. Hue persists while the
/// colour is grey. Thread: gui.
class ColorWheel : public QWidget
{
    Q_OBJECT

public:
    explicit ColorWheel(QWidget* parent = nullptr);

    core::Rgb color() const;
    /// Sets the colour without emitting colorChanged().
    void setColor(const core::Rgb& color);

    QSize sizeHint() const override { return {160, 160}; }
    QSize minimumSizeHint() const override { return {144, 144}; }

    /// Return the widget position of a hue, or of a saturation and value. Units: all 0 to 1.
    QPointF placeOfHue(double hue) const;
    QPointF placeInSquare(double saturation, double value) const;

Q_SIGNALS:
    /// The user has changed the colour.
    void colorChanged(const core::Rgb& color);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Part { Ring, Square };

    double outerRadius() const;
    QPointF middle() const;
    QRectF square() const;
    void drag(const QPointF& to);
    void set(double hue, double saturation, double value);
    void drawRing(QPainter& painter) const;
    void drawSquare(QPainter& painter) const;
    void drawHandle(QPainter& painter, const QPointF& at, const QColor& inside) const;

    double m_hue = 0, m_saturation = 0, m_value = 0; ///< all 0 to 1
    Part m_dragged = Part::Square;
};
} // namespace ui
