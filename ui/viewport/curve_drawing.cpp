#include "ui/viewport/curve_drawing.h"

#include "ui/viewport/viewport.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
constexpr double closingDistance = 8; ///< pixels from a polygon's first corner at which a click closes it
constexpr double leastSize = 3;       ///< pixels; a smaller curve is begun again
constexpr int hintMargin = 12;        ///< pixels from the view's top
constexpr double cornerRadius = 3;    ///< pixels
} // namespace

CurveDrawing::CurveDrawing(Viewport* viewport) : QWidget(viewport), m_viewport(viewport), m_hint(new QLabel(this))
{
    setObjectName(QStringLiteral("curveDrawing"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    m_hint->setObjectName(QStringLiteral("curveHint"));
    m_hint->setStyleSheet(
        QStringLiteral("background: rgba(28, 30, 33, 225); color: white; border-radius: 4px; padding: 4px 8px;"));
    hide();
    viewport->installEventFilter(this);
}

void CurveDrawing::begin(CurveShape shape)
{
    if (!m_viewport->isVisible() || m_viewport->input()->strokeOpen() || m_viewport->input()->isPressPending())
        return;
    m_shape = shape;
    m_points.clear();
    m_isOutside = false;
    m_releaseFollows = false;
    m_viewport->input()->pointerLeft();
    m_viewport->setFocus();
    m_viewport->setCursor(Qt::CrossCursor);
    setGeometry(m_viewport->rect());
    showHint();
    show();
    raise();
    update();
}

void CurveDrawing::cancel()
{
    m_shape.reset();
    m_points.clear();
    m_viewport->setCursor(Qt::ArrowCursor);
    hide();
}

bool CurveDrawing::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonRelease:
    case QEvent::TabletMove:
    case QEvent::TabletPress:
    case QEvent::TabletRelease:
        if (handlePointer(*static_cast<QSinglePointEvent*>(event))) {
            event->accept();
            return true;
        }
        break;
    case QEvent::Wheel:
        if (isActive() && !m_points.isEmpty())
            return true;
        break;
    case QEvent::ShortcutOverride: // claims Esc, which would otherwise trigger an action
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
        if (isActive() && handleKey(*static_cast<QKeyEvent*>(event))) {
            event->accept();
            return true;
        }
        break;
    case QEvent::Resize:
    case QEvent::TouchBegin:
    case QEvent::Hide:
    case QEvent::WindowBlocked:
        if (isActive())
            cancel();
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

bool CurveDrawing::handleKey(const QKeyEvent& event)
{
    const bool isPress = event.type() == QEvent::KeyPress;
    switch (event.key()) {
    case Qt::Key_Shift:
        if (event.type() != QEvent::ShortcutOverride)
            setOutside(isPress);
        return true;
    case Qt::Key_Escape:
        if (isPress)
            cancel();
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (isPress && m_shape == CurveShape::Polygon)
            close();
        return true;
    case Qt::Key_Backspace:
        if (isPress && m_shape == CurveShape::Polygon && !m_points.isEmpty())
            m_points.removeLast();
        update();
        return true;
    default:
        return false;
    }
}

/// Handles a pointer event; returns true if it is consumed. Also consumes the release of the press that ended the
/// curve.
bool CurveDrawing::handlePointer(const QSinglePointEvent& event)
{
    if (event.isEndEvent() && std::exchange(m_releaseFollows, false))
        return true;
    if (!isActive())
        return false;
    const bool movesView = m_points.isEmpty() && event.button() == Qt::MiddleButton;
    const bool isMovingView = m_points.isEmpty() && event.isUpdateEvent() && event.buttons() & Qt::MiddleButton;
    if (movesView || isMovingView)
        return false;
    setOutside(event.modifiers() & Qt::ShiftModifier);
    if (event.isBeginEvent() || event.type() == QEvent::MouseButtonDblClick) // Qt calls a double click an update
        press(event);
    else if (event.isUpdateEvent())
        moveTo(event.position());
    else if (event.button() == Qt::LeftButton)
        release();
    return true;
}

void CurveDrawing::press(const QSinglePointEvent& event)
{
    if (event.button() == Qt::RightButton) {
        m_releaseFollows = true;
        return cancel();
    }
    if (event.button() != Qt::LeftButton)
        return;
    m_pointer = event.position();
    if (m_shape != CurveShape::Polygon) {
        m_points = QPolygonF({event.position()});
        update();
    } else if (event.type() == QEvent::MouseButtonDblClick) {
        m_releaseFollows = true;
        close();
    } else {
        addCorner(event.position());
    }
}

void CurveDrawing::addCorner(const QPointF& position)
{
    if (m_points.size() > 2 && QLineF(position, m_points.front()).length() < closingDistance) {
        m_releaseFollows = true;
        return close();
    }
    m_points << position;
    update();
}

void CurveDrawing::moveTo(const QPointF& position)
{
    m_pointer = position;
    if (m_points.isEmpty())
        return;
    if (m_shape == CurveShape::Lasso && position != m_points.back())
        m_points << position;
    update();
}

void CurveDrawing::release()
{
    if (m_shape != CurveShape::Polygon && !m_points.isEmpty())
        close();
}

/// Returns the curve as it would be closed now.
QPolygonF CurveDrawing::curve() const
{
    if (m_points.isEmpty())
        return {};
    if (m_shape == CurveShape::Box || m_shape == CurveShape::Line)
        return curveBetween(*m_shape, m_points.front(), m_pointer, size());
    return m_points;
}

/// Ends the drawing. A curve without extent is begun again instead.
void CurveDrawing::close()
{
    const QPolygonF closed = simplified(curve());
    const QRectF around = closed.boundingRect();
    if (closed.size() < 3 || std::max(around.width(), around.height()) < leastSize) {
        if (m_shape != CurveShape::Polygon)
            m_points.clear();
        return update();
    }
    const bool isOutside = m_isOutside;
    cancel();
    Q_EMIT drawn(closed, isOutside);
}

void CurveDrawing::setOutside(bool isOutside)
{
    if (std::exchange(m_isOutside, isOutside) != isOutside)
        update();
}

void CurveDrawing::showHint()
{
    const QString hints[] = {
        tr("Draw around what is to go. Shift: what is around it goes. Esc cancels."),
        tr("Drag a box over what is to go. Shift: what is around it goes. Esc cancels."),
        tr("Drag a line: what is tinted goes. Shift: the other side goes. Esc cancels."),
        tr("Click corners around what is to go; double click ends. Shift: what is around it goes. Esc cancels.")};
    static_assert(std::size(hints) == static_cast<std::size_t>(CurveShape::Polygon) + 1);
    m_hint->setText(hints[static_cast<std::size_t>(*m_shape)]);
    m_hint->setMaximumWidth(width());
    m_hint->setWordWrap(m_hint->sizeHint().width() > width());
    m_hint->adjustSize();
    m_hint->move((width() - m_hint->width()) / 2, hintMargin);
}

/// Tints what goes. Draws a light line with dark edges, to be visible on every material.
void CurveDrawing::paintEvent(QPaintEvent*)
{
    QPolygonF closed = curve();
    if (m_shape == CurveShape::Polygon && !closed.isEmpty())
        closed << m_pointer;
    if (closed.size() < 2)
        return;
    QPainterPath path;
    path.addPolygon(closed);
    path.closeSubpath();
    path.setFillRule(Qt::WindingFill);
    QPainterPath tinted = path;
    if (m_isOutside) {
        QPainterPath whole;
        whole.addRect(rect());
        tinted = whole.subtracted(path);
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(tinted, QColor(215, 60, 45, 80));
    painter.strokePath(path, QPen(QColor(0, 0, 0, 110), 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(path, QPen(QColor(255, 246, 232), 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (m_shape != CurveShape::Polygon)
        return;
    painter.setBrush(QColor(255, 246, 232));
    for (const QPointF& corner : std::as_const(m_points))
        painter.drawEllipse(corner, cornerRadius, cornerRadius);
}
} // namespace ui
