#include "ui/viewport/curve_drawing.h"

#include "ui/util/pointer_events.h"
#include "ui/viewport/area_bar.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/view_hint.h"

#include <QKeyEvent>
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
constexpr double minSize = 3;         ///< pixels; a smaller curve is begun again
constexpr int barMargin = 6;          ///< pixels from the hint to the bar
constexpr double cornerRadius = 3;    ///< pixels
constexpr QColor warning(215, 60, 45, 80), selecting(60, 120, 215, 80);

/// Returns how to draw, and what will happen.
QString hintFor(AreaUse areaUse, const AreaBar& bar, bool isOutside)
{
    const QString gestures[] = {CurveDrawing::tr("Draw around an area."), CurveDrawing::tr("Drag a box over an area."),
                                CurveDrawing::tr("Drag a line; the area is on its right."),
                                CurveDrawing::tr("Click the corners of an area; a double click ends.")};
    static_assert(std::size(gestures) == static_cast<std::size_t>(CurveShape::Polygon) + 1);
    const QString inside[] = {
        CurveDrawing::tr("What is inside is masked."), CurveDrawing::tr("The mask inside is removed."),
        CurveDrawing::tr("What is inside is hidden."), CurveDrawing::tr("What is inside is cut away."),
        CurveDrawing::tr("What is inside becomes a part of its own.")};
    const QString outside[] = {
        CurveDrawing::tr("What is outside is masked."), CurveDrawing::tr("The mask outside is removed."),
        CurveDrawing::tr("What is outside is hidden."), CurveDrawing::tr("What is outside is cut away."),
        CurveDrawing::tr("What is outside becomes a part of its own.")};
    static_assert(std::size(inside) == static_cast<std::size_t>(AreaUse::Split) + 1);
    static_assert(std::size(outside) == std::size(inside));
    const auto use = static_cast<std::size_t>(areaUse);
    QStringList sentences{gestures[static_cast<std::size_t>(bar.shape())], isOutside ? outside[use] : inside[use]};
    if (bar.isFrontOnly())
        sentences << CurveDrawing::tr("Only what is in front counts.");
    return (sentences << CurveDrawing::tr("Shift: the other side. Esc cancels.")).join(QLatin1Char(' '));
}

/// Returns what a curve without area lacks.
QString refusalOf(CurveShape shape)
{
    switch (shape) {
    case CurveShape::Lasso:
        break;
    case CurveShape::Box:
        return CurveDrawing::tr("The box is too small: drag from one corner to the opposite one.");
    case CurveShape::Line:
        return CurveDrawing::tr("The line is too short: drag it across the model.");
    case CurveShape::Polygon:
        return CurveDrawing::tr("A polygon needs at least three corners that are not in one line.");
    }
    return CurveDrawing::tr("The lasso is too small: drag it around something.");
}
} // namespace

CurveDrawing::CurveDrawing(Viewport* viewport)
    : QWidget(viewport)
    , m_viewport(viewport)
    , m_hint(new ViewHint("curveHint", this))
    , m_bar(new AreaBar(viewport))
{
    setObjectName(QStringLiteral("curveDrawing"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    viewport->installEventFilter(this);
    connect(m_bar, &AreaBar::shapeChanged, this, [this] {
        if (isActive())
            begin(*m_use);
    });
    connect(m_bar, &AreaBar::extentChanged, this, [this] {
        if (isActive())
            showHint();
        update();
    });
    connect(viewport->input(), &PointerInput::modeChanged, this, [this](PointerMode mode) {
        if (isActive() && mode != PointerMode::Sculpt)
            cancel();
    });
}

void CurveDrawing::begin(AreaUse use)
{
    if (!m_viewport->isVisible() || m_viewport->input()->strokeOpen() || m_viewport->input()->isPressPending())
        return;
    m_use = use;
    m_bar->setUse(use);
    m_points.clear();
    m_isShiftHeld = false;
    m_releaseFollows = false;
    m_viewport->input()->setMode(PointerMode::Sculpt); // ends handles over the view
    m_viewport->input()->pointerLeft();
    m_viewport->setFocus();
    m_viewport->setCursor(Qt::CrossCursor);
    setGeometry(m_viewport->rect());
    showHint();
    show();
    raise();
    m_bar->show();
    m_bar->raise();
    update();
}

void CurveDrawing::cancel()
{
    m_use.reset();
    m_points.clear();
    m_viewport->setCursor(Qt::ArrowCursor);
    m_bar->hide();
    hide();
}

bool CurveDrawing::eventFilter(QObject* watched, QEvent* event)
{
    if (const QSinglePointEvent* pointer = pointerEventIn(*event); pointer && handlePointer(*pointer)) {
        event->accept();
        return true;
    }
    switch (event->type()) {
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
            setShift(isPress);
        return true;
    case Qt::Key_Escape:
        if (isPress)
            cancel();
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (isPress && m_bar->shape() == CurveShape::Polygon)
            close();
        return true;
    case Qt::Key_Backspace:
        if (isPress && m_bar->shape() == CurveShape::Polygon && !m_points.isEmpty())
            m_points.removeLast();
        update();
        return true;
    default:
        return m_bar->handleKey(event);
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
    setShift(event.modifiers() & Qt::ShiftModifier);
    if (isPress(event))
        press(event);
    else if (event.isUpdateEvent())
        moveTo(event.position());
    else if (event.button() == Qt::LeftButton && m_bar->shape() != CurveShape::Polygon && !m_points.isEmpty())
        close();
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
    if (m_bar->shape() != CurveShape::Polygon) {
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
    if (m_bar->shape() == CurveShape::Lasso && position != m_points.back())
        m_points << position;
    update();
}

/// Returns the curve as it would be closed now.
QPolygonF CurveDrawing::curve() const
{
    if (m_points.isEmpty())
        return {};
    if (m_bar->shape() == CurveShape::Box || m_bar->shape() == CurveShape::Line)
        return curveBetween(m_bar->shape(), m_points.front(), m_pointer, size());
    return m_points;
}

/// Ends the drawing. A curve without area is begun again instead.
void CurveDrawing::close()
{
    const QPolygonF closed = simplified(curve());
    const QRectF around = closed.boundingRect();
    if (closed.size() < 3 || std::max(around.width(), around.height()) < minSize) {
        if (m_bar->shape() != CurveShape::Polygon)
            m_points.clear();
        update();
        return Q_EMIT refused(refusalOf(m_bar->shape()));
    }
    const DrawnArea area{*m_use, closed, isOutside(), m_bar->isFrontOnly(), m_bar->isColored()};
    cancel();
    Q_EMIT drawn(area);
}

bool CurveDrawing::isOutside() const
{
    return m_bar->isOutside() != m_isShiftHeld;
}

void CurveDrawing::setShift(bool isHeld)
{
    if (std::exchange(m_isShiftHeld, isHeld) == isHeld)
        return;
    showHint();
    update();
}

void CurveDrawing::showHint()
{
    m_hint->showText(hintFor(*m_use, *m_bar, isOutside()), width());
    m_bar->adjustSize();
    const int left = (width() - m_bar->width()) / 2, below = m_hint->geometry().bottom() + barMargin;
    m_bar->move(left, left < ViewHint::corner ? std::max(below, ViewHint::corner) : below);
}

/// Tints the area; in red what will be cut away. Draws a light line with dark edges, to be visible on every material.
void CurveDrawing::paintEvent(QPaintEvent*)
{
    QPolygonF closed = curve();
    if (m_bar->shape() == CurveShape::Polygon && !closed.isEmpty())
        closed << m_pointer;
    if (closed.size() < 2)
        return;
    QPainterPath path;
    path.addPolygon(closed);
    path.closeSubpath();
    path.setFillRule(Qt::WindingFill);
    QPainterPath tinted = path;
    if (isOutside()) {
        QPainterPath whole;
        whole.addRect(rect());
        tinted = whole.subtracted(path);
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(tinted, m_use == AreaUse::Trim ? warning : selecting);
    painter.strokePath(path, QPen(QColor(0, 0, 0, 110), 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(path, QPen(QColor(255, 246, 232), 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (m_bar->shape() != CurveShape::Polygon)
        return;
    painter.setBrush(QColor(255, 246, 232));
    for (const QPointF& corner : std::as_const(m_points))
        painter.drawEllipse(corner, cornerRadius, cornerRadius);
}
} // namespace ui
