#include "ui/headset/simulator_view.h"

#include <QKeyEvent>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui
{
namespace
{
using core::Vec3;

/// Trigger value of a press at half strength: midway between the value at which a trigger begins to act and 1.
constexpr double halfPull = 0.725;
/// Distance of the thumb from the pad's centre when it presses a side, in radii.
constexpr double padEdge = 0.8;
constexpr double radiansPerPixel = 0.004;   ///< head turn for a pixel of mouse motion
constexpr double slidePerPixel = 1.0 / 120; ///< thumb motion for a pixel of mouse motion, in pad radii
constexpr double reachPerNotch = 0.02;      ///< metres for each notch of the wheel
constexpr double radiansPerNotch = 0.2;     ///< rotation of the wand for each notch of the wheel
constexpr double notch = 120;               ///< one notch of a wheel in Qt's units (1/8 degree)
constexpr double walkingSpeed = 0.8;        ///< metres per second
constexpr double minDepth = 0.005;          ///< metres; smaller depths are not shown
/// Pixels: margin around the depth text, and distance from the mouse up to the text.
constexpr double textMargin = 6, textAbove = 40;

struct WalkingKey
{
    int key;
    Vec3 way; ///< unit vector: right, up, backwards
};
const WalkingKey walkingKeys[] = {{Qt::Key_W, -Vec3::UnitZ()}, {Qt::Key_S, Vec3::UnitZ()}, {Qt::Key_A, -Vec3::UnitX()},
                                  {Qt::Key_D, Vec3::UnitX()},  {Qt::Key_E, Vec3::UnitY()}, {Qt::Key_Q, -Vec3::UnitY()}};

struct PadKey
{
    int key;
    Eigen::Vector2d thumb;
};
const PadKey padKeys[] = {{Qt::Key_Left, {-padEdge, 0}},
                          {Qt::Key_Right, {padEdge, 0}},
                          {Qt::Key_Up, {0, padEdge}},
                          {Qt::Key_Down, {0, -padEdge}}};

/// Returns the text for a tip `depth` metres behind the surface under the mouse; empty if the tip is at the surface.
QString depthText(double depth)
{
    if (std::abs(depth) < minDepth)
        return {};
    const QString centimetres = QLocale().toString(100 * std::abs(depth), 'f', 0);
    //: %1: a number
    return depth < 0 ? SimulatorView::tr("%1 cm before the surface").arg(centimetres)
                     : SimulatorView::tr("%1 cm behind the surface").arg(centimetres);
}

/// Paints a text above the mouse, where neither the wand nor its labels are, moved into the picture if necessary.
void paintAbove(QPainter& painter, const QString& text, const QPointF& mouse, const QRectF& picture)
{
    if (text.isEmpty())
        return;
    QRectF plate = QFontMetricsF(painter.font()).boundingRect(text);
    plate.adjust(-textMargin, -textMargin, textMargin, textMargin);
    const QPointF wanted = mouse - QPointF(plate.width() / 2, plate.height() + textAbove);
    plate.moveTopLeft(
        {std::clamp(wanted.x(), picture.left(), std::max(picture.left(), picture.right() - plate.width())),
         std::clamp(wanted.y(), picture.top(), std::max(picture.top(), picture.bottom() - plate.height()))});
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 190));
    painter.drawRoundedRect(plate, textMargin, textMargin);
    painter.setPen(Qt::white);
    painter.drawText(plate, Qt::AlignCenter, text);
}
} // namespace

SimulatorView::SimulatorView(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setCursor(Qt::CrossCursor);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void SimulatorView::begin()
{
    m_controls = {};
    m_picture = {};
    m_walking.clear();
    Q_EMIT handChanged();
    update();
}

void SimulatorView::setPicture(const QImage& picture)
{
    m_picture = picture;
    update();
}

void SimulatorView::advance(double seconds)
{
    for (const WalkingKey& walk : walkingKeys)
        if (m_walking.contains(walk.key))
            m_controls.walk(walkingSpeed * seconds * walk.way);
}

/// Returns the rectangle of the picture, as large as fits the widget.
QRectF SimulatorView::frame() const
{
    const QSizeF size =
        QSizeF(SimulatorControls::sideTangent, SimulatorControls::upTangent).scaled(this->size(), Qt::KeepAspectRatio);
    return {QPointF(width() - size.width(), height() - size.height()) / 2, size};
}

QPointF SimulatorView::placeOf(const Eigen::Vector2d& place) const
{
    const QRectF area = frame();
    return area.center() + QPointF(place.x() * area.width() / 2, -place.y() * area.height() / 2);
}

void SimulatorView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!m_picture.isNull()) {
        painter.drawImage(frame(), m_picture);
        return paintAbove(painter, depthText(m_controls.depth().value_or(0)), m_mouse, frame());
    }
    painter.setPen(Qt::white);
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("VR starts…"));
}

void SimulatorView::mousePressEvent(QMouseEvent* event)
{
    m_mouse = event->position();
    if (event->button() == Qt::LeftButton)
        pressTrigger(true, event->modifiers());
}

void SimulatorView::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        pressTrigger(false, event->modifiers());
}

void SimulatorView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF by = event->position() - std::exchange(m_mouse, event->position());
    if (event->modifiers().testFlag(Qt::ControlModifier))
        return slide(by);
    if (event->buttons().testFlag(Qt::RightButton)) {
        m_controls.turnHead(-radiansPerPixel * by.x(), -radiansPerPixel * by.y());
        Q_EMIT headTurned();
        return;
    }
    const QRectF area = frame();
    const QPointF from = m_mouse - area.center();
    m_controls.pointAt({2 * from.x() / area.width(), -2 * from.y() / area.height()});
}

void SimulatorView::wheelEvent(QWheelEvent* event)
{
    const double notches = event->angleDelta().y() / notch;
    if (event->modifiers().testFlag(Qt::ShiftModifier))
        m_controls.turn(radiansPerNotch * notches);
    else
        m_controls.reach(reachPerNotch * notches);
}

void SimulatorView::keyPressEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat())
        return;
    if (event->key() == Qt::Key_Escape)
        Q_EMIT escaped();
    else if (event->key() == Qt::Key_Tab)
        changeHand();
    else if (!press(*event, true))
        QWidget::keyPressEvent(event);
}

void SimulatorView::keyReleaseEvent(QKeyEvent* event)
{
    if (!event->isAutoRepeat() && !press(*event, false))
        QWidget::keyReleaseEvent(event);
}

/// Handles a key of the simulator. Returns false if the key has no function here.
bool SimulatorView::press(const QKeyEvent& event, bool isDown)
{
    const int key = event.key();
    if (std::ranges::any_of(walkingKeys, [key](const WalkingKey& walk) { return walk.key == key; })) {
        if (isDown)
            m_walking.insert(key);
        else
            m_walking.remove(key);
        return true;
    }
    switch (key) {
    case Qt::Key_Space:
        pressTrigger(isDown, event.modifiers());
        return true;
    case Qt::Key_M:
        buttons().pressesMenu = isDown;
        break;
    case Qt::Key_G:
        squeeze({m_controls.hand()}, isDown);
        break;
    case Qt::Key_B:
        squeeze({SimulatedHand::Left, SimulatedHand::Right}, isDown);
        break;
    case Qt::Key_Control:
        buttons().touchesPad = isDown;
        buttons().pad.setZero();
        break;
    default:
        if (!pressPad(key, isDown))
            return false;
    }
    Q_EMIT buttonsChanged();
    return true;
}

/// Sets the squeeze buttons. A released key releases both hands, because the mouse may have changed hands meanwhile.
void SimulatorView::squeeze(std::initializer_list<SimulatedHand> hands, bool isDown)
{
    for (SimulatedButtons* each : {&m_controls.buttons(SimulatedHand::Left), &m_controls.buttons(SimulatedHand::Right)})
        each->squeezes = each->squeezes && isDown;
    for (const SimulatedHand hand : hands)
        m_controls.buttons(hand).squeezes = isDown;
}

bool SimulatorView::pressPad(int key, bool isDown)
{
    const PadKey* const side = std::ranges::find(padKeys, key, &PadKey::key);
    if (side == std::end(padKeys))
        return false;
    buttons().pressesPad = buttons().touchesPad = isDown;
    buttons().pad = isDown ? side->thumb : Eigen::Vector2d::Zero();
    return true;
}

void SimulatorView::pressTrigger(bool isDown, Qt::KeyboardModifiers modifiers)
{
    const double down = modifiers.testFlag(Qt::ShiftModifier) ? halfPull : 1;
    buttons().trigger = isDown ? down : 0;
    Q_EMIT buttonsChanged();
}

/// Moves the thumb on the pad by pixels of mouse motion; it stops at the edge.
void SimulatorView::slide(const QPointF& by)
{
    if (!buttons().touchesPad)
        return;
    Eigen::Vector2d& pad = buttons().pad;
    pad += slidePerPixel * Eigen::Vector2d(by.x(), -by.y());
    if (pad.norm() > 1)
        pad.normalize();
}

void SimulatorView::changeHand()
{
    const bool squeezes = buttons().squeezes;
    buttons() = {};
    buttons().squeezes = squeezes;
    m_controls.swapHands();
    Q_EMIT buttonsChanged();
    Q_EMIT handChanged();
}

/// Releases all buttons when the widget loses the focus.
void SimulatorView::focusOutEvent(QFocusEvent* event)
{
    m_walking.clear();
    for (const SimulatedHand hand : {SimulatedHand::Left, SimulatedHand::Right})
        m_controls.buttons(hand) = {};
    Q_EMIT buttonsChanged();
    QWidget::focusOutEvent(event);
}
} // namespace ui
