#include "ui/viewport/brush_drag.h"

#include "ui/util/error_messages.h"
#include "ui/util/pointer_events.h"
#include "ui/viewport/viewport.h"

#include <QKeyEvent>
#include <QLocale>

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
constexpr double strengthPerPixel = 0.005;
constexpr int labelDistance = 24; ///< pixels between ring and label
} // namespace

BrushDrag::BrushDrag(BrushSettings* brush, Viewport* viewport) : QLabel(viewport), m_brush(brush), m_viewport(viewport)
{
    setObjectName(QStringLiteral("brushDrag"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setStyleSheet(
        QStringLiteral("background: rgba(28, 30, 33, 225); color: white; border-radius: 4px; padding: 4px 8px;"));
    hide();
    connect(brush, &BrushSettings::changed, this, &BrushDrag::showValue);
    viewport->installEventFilter(this);
}

void BrushDrag::begin(core::Parameter parameter)
{
    if (isActive())
        return accept();
    if (!m_viewport->isVisible() || m_viewport->input()->strokeOpen() || m_viewport->input()->isPressPending())
        return;
    m_parameter = parameter;
    m_from.reset();
    m_before = m_brush->value(parameter);
    m_viewport->setFocus();
    const QPoint pointer = m_viewport->mapFromGlobal(QCursor::pos());
    m_center = m_viewport->rect().contains(pointer) ? pointer : m_viewport->rect().center();
    showValue();
    show();
}

bool BrushDrag::eventFilter(QObject* watched, QEvent* event)
{
    if (const QSinglePointEvent* pointer = pointerEventIn(*event); pointer && handlePointer(*pointer)) {
        event->accept();
        return true;
    }
    switch (event->type()) {
    case QEvent::ShortcutOverride: // claims Esc, which would otherwise trigger an action
    case QEvent::KeyPress:
        if (isActive() && handleKey(static_cast<QKeyEvent*>(event)->key())) {
            event->accept();
            return true;
        }
        break;
    case QEvent::TouchBegin:
    case QEvent::Hide:
    case QEvent::WindowBlocked:
        accept();
        break;
    default:
        break;
    }
    return QLabel::eventFilter(watched, event);
}

bool BrushDrag::handleKey(int key)
{
    if (key == Qt::Key_Escape)
        cancel();
    else if (key == Qt::Key_Return || key == Qt::Key_Enter)
        accept();
    else
        return false;
    return true;
}

/// Handles a pointer event; returns true if it is consumed. Also consumes the release of the press that ended the
/// change.
bool BrushDrag::handlePointer(const QSinglePointEvent& event)
{
    if (event.isEndEvent())
        return std::exchange(m_releaseFollows, false) || isActive();
    if (!isActive())
        return false;
    if (event.isUpdateEvent()) {
        moveTo(event.position().x());
        return true;
    }
    m_releaseFollows = true;
    event.button() == Qt::RightButton ? cancel() : accept();
    return true;
}

/// Changes the value by the pointer's movement. A change of radius moves the ring's edge as far as the pointer.
void BrushDrag::moveTo(double x)
{
    const core::Parameter parameter = *m_parameter;
    const double moved = x - m_from.value_or(x);
    m_from = x - moved;
    const double perPixel =
        parameter == core::Parameter::Radius ? 1 / m_viewport->input()->pixelsPerMm() : strengthPerPixel;
    m_brush->setValue(parameter,
                      std::clamp(m_before + moved * perPixel, m_brush->minOf(parameter), m_brush->maxOf(parameter)));
}

void BrushDrag::accept()
{
    m_parameter.reset();
    hide();
}

void BrushDrag::cancel()
{
    const core::Parameter parameter = *m_parameter;
    accept();
    m_brush->setValue(parameter, m_before);
}

void BrushDrag::showValue()
{
    if (!isActive())
        return;
    const double value = m_brush->value(*m_parameter);
    const QString name = ErrorMessages::name(*m_parameter);
    if (*m_parameter == core::Parameter::Radius)
        setText(tr("%1: %2 mm").arg(name, locale().toString(value, 'g', 3)));
    else
        setText(tr("%1: %2").arg(name, locale().toString(value, 'f', 2)));
    adjustSize();
    place();
}

/// Puts the label beside the ring and lower than the pointer, which is at the ring's edge.
void BrushDrag::place()
{
    const bool isRadius = *m_parameter == core::Parameter::Radius;
    const double rim = isRadius ? m_brush->value(core::Parameter::Radius) * m_viewport->input()->pixelsPerMm() : 0;
    const QPoint beside =
        m_center + QPoint(qRound(std::min<double>(rim, m_viewport->width())) + labelDistance, labelDistance);
    const QPoint corner(m_viewport->width() - width(), m_viewport->height() - height());
    move(std::clamp(beside.x(), 0, std::max(corner.x(), 0)), std::clamp(beside.y(), 0, std::max(corner.y(), 0)));
}
} // namespace ui
