#include "ui/drawing/drawing_canvas.h"

#include <QEvent>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui
{
namespace
{
constexpr double maxZoom = 40, zoomPerKey = 1.25;
constexpr int stepPerKey = 32, edge = 8;

/// All inputs of a picture, passed by value to the background thread.
struct Order
{
    SharedDrawing drawing;
    DrawingSettings options;
    DrawingStyle style;
    QSize size;
    double pixelRatio, zoom;
    QPointF shift;
};

QImage pictureOf(const Order& order)
{
    QImage picture(order.size * order.pixelRatio, QImage::Format_ARGB32_Premultiplied);
    picture.setDevicePixelRatio(order.pixelRatio);
    picture.fill(Qt::transparent);
    if (!order.drawing)
        return picture;
    QPainter painter(&picture);
    const QRectF area = QRectF({}, QSizeF(order.size)).adjusted(edge, edge, -edge, -edge);
    const DrawingLayout layout = bestLayout(*order.drawing, order.options, order.style, area.size());
    if (const double scale = layout.scaleFor(area.size()); scale > 0)
        layout.paint(painter, area.center() + order.shift, scale * order.zoom);
    return picture;
}

QColor mixed(const QColor& one, const QColor& other)
{
    return QColor::fromRgb((2 * one.red() + other.red()) / 3, (2 * one.green() + other.green()) / 3,
                           (2 * one.blue() + other.blue()) / 3);
}
} // namespace

DrawingCanvas::DrawingCanvas(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
}

void DrawingCanvas::setDrawing(SharedDrawing drawing)
{
    m_drawing = std::move(drawing);
    render();
}

void DrawingCanvas::setOptions(const DrawingSettings& options)
{
    if (options.sides != m_options.sides) {
        m_zoom = 1;
        m_shift = {};
    }
    m_options = options;
    render();
}

void DrawingCanvas::fit()
{
    m_zoom = 1;
    m_shift = {};
    render();
}

void DrawingCanvas::zoomBy(double factor, const QPointF& at)
{
    const double zoom = std::clamp(m_zoom * factor, 1.0, maxZoom);
    const QPointF middle = QRectF(rect()).center(), from = at - middle;
    m_shift = zoom == 1 ? QPointF() : from + (m_shift - from) * (zoom / m_zoom);
    m_zoom = zoom;
    render();
}

void DrawingCanvas::moveBy(const QPointF& step)
{
    const QPointF max = QPointF(width(), height()) * (m_zoom / 2);
    m_shift += step;
    m_shift = {std::clamp(m_shift.x(), -max.x(), max.x()), std::clamp(m_shift.y(), -max.y(), max.y())};
    render();
}

/// Starts rendering unless a picture is being rendered. In that case the next picture starts when the present one is
/// finished, with all changes made meanwhile.
void DrawingCanvas::render()
{
    m_isOutdated = m_isRendering;
    if (m_isRendering || size().isEmpty())
        return;
    m_isRendering = true;
    QFont small = font();
    small.setPixelSize(std::max(10, QFontInfo(font()).pixelSize() - 2));
    const QColor ink = palette().color(QPalette::Text);
    const DrawingStyle style{ink, mixed(ink, palette().color(QPalette::Base)), 1.6, small};
    m_background.run([order = Order{m_drawing, m_options, style, size(), devicePixelRatioF(), m_zoom,
                                    m_shift}] { return pictureOf(order); },
                     [this](const QImage& picture) { setPicture(picture); });
}

void DrawingCanvas::setPicture(const QImage& picture)
{
    m_isRendering = false;
    m_picture = picture;
    update();
    if (std::exchange(m_isOutdated, false))
        render();
    else
        Q_EMIT painted();
}

void DrawingCanvas::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.drawImage(0, 0, m_picture);
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void DrawingCanvas::resizeEvent(QResizeEvent*)
{
    render();
}

void DrawingCanvas::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        render();
    QWidget::changeEvent(event);
}

void DrawingCanvas::wheelEvent(QWheelEvent* event)
{
    zoomBy(std::pow(2.0, event->angleDelta().y() / 480.0), event->position());
    event->accept();
}

void DrawingCanvas::mousePressEvent(QMouseEvent* event)
{
    m_draggedFrom = event->position();
}

void DrawingCanvas::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() != Qt::NoButton)
        moveBy(event->position() - std::exchange(m_draggedFrom, event->position()));
}

void DrawingCanvas::mouseDoubleClickEvent(QMouseEvent*)
{
    fit();
}

void DrawingCanvas::keyPressEvent(QKeyEvent* event)
{
    const QPointF middle = QRectF(rect()).center();
    switch (event->key()) {
    case Qt::Key_Plus:
        return zoomBy(zoomPerKey, middle);
    case Qt::Key_Minus:
        return zoomBy(1 / zoomPerKey, middle);
    case Qt::Key_0:
        return fit();
    case Qt::Key_Left:
        return moveBy({stepPerKey, 0});
    case Qt::Key_Right:
        return moveBy({-stepPerKey, 0});
    case Qt::Key_Up:
        return moveBy({0, stepPerKey});
    case Qt::Key_Down:
        return moveBy({0, -stepPerKey});
    default:
        QWidget::keyPressEvent(event);
    }
}
} // namespace ui
