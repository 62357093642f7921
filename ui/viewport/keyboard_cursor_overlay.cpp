#include "ui/viewport/keyboard_cursor_overlay.h"

#include <QPainter>

namespace ui
{
namespace
{
// Lengths in pixels.
constexpr int overlaySide = 33;
constexpr double arm = 14, hole = 5;
} // namespace

KeyboardCursorOverlay::KeyboardCursorOverlay(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("keyCross"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    resize(overlaySide, overlaySide);
    hide();
}

void KeyboardCursorOverlay::place(const QPointF& at, bool down)
{
    m_isDown = down;
    move(at.toPoint() - rect().center());
    show();
    update();
}

/// Draws a light cross with dark edges, to be visible on every material. A pressed cursor has a ring in its middle.
void KeyboardCursorOverlay::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(QRectF(rect()).center());
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 150), 4, Qt::SolidLine, Qt::RoundCap),
                            QPen(QColor(255, 246, 232), 1.8, Qt::SolidLine, Qt::RoundCap)}) {
        painter.setPen(pen);
        for (const QPointF& direction : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(hole * direction, arm * direction);
        if (m_isDown)
            painter.drawEllipse(QPointF(), hole, hole);
    }
}
} // namespace ui
