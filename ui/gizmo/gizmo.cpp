#include "ui/gizmo/gizmo.h"

#include "ui/input/pointer_input.h"
#include "ui/util/pointer_events.h"
#include "ui/viewport/viewport.h"

#include "core/stroke/symmetry_plane.h"

#include <QKeyEvent>
#include <QPainter>

#include <utility>

namespace ui
{
GizmoFrame moved(const GizmoFrame& frame, const core::Transform& by)
{
    return {by.placeOf(frame.centre, 1), (by.rotation * frame.axes).normalized()};
}

Gizmo::Gizmo(Viewport* viewport, GizmoShape::Handles handles)
    : QWidget(viewport)
    , m_viewport(viewport)
    , m_handles(handles)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    viewport->installEventFilter(this);
    connect(viewport, &Viewport::drawing, this, &Gizmo::followCamera);
    connect(viewport->input(), &PointerInput::modeChanged, this, &Gizmo::followMode);
}

void Gizmo::setFrame(const std::optional<GizmoFrame>& frame)
{
    if (m_drag && frame) {
        m_start = *frame;
        return;
    }
    const bool wasShown = m_frame.has_value();
    if (frame && !wasShown)
        m_viewport->input()->setMode(PointerMode::Sculpt); // ends another gizmo of the view
    m_frame = frame;
    if (frame && !wasShown) {
        setGeometry(m_viewport->rect());
        show();
        raise();
        m_releaseFollows = false;
        m_viewport->input()->setMode(PointerMode::Handles);
        m_viewport->setFocus();
    } else if (!frame && wasShown) {
        m_drag.reset();
        setHot({});
        hide();
        m_viewport->input()->setMode(PointerMode::Handles, false);
    }
    update();
}

/// Draws the handles again if the camera has moved. Drawing them draws the view, so it must not happen each time.
void Gizmo::followCamera()
{
    const OrbitCamera& camera = m_viewport->camera();
    const Eigen::Matrix4d view = camera.projectionMatrix() * camera.viewMatrix();
    if (m_frame && view != m_view)
        update();
}

/// Ends with the pointer's mode. Esc returns to sculpting; during a drag it takes the drag back instead.
void Gizmo::followMode()
{
    if (!m_frame || m_viewport->input()->mode() == PointerMode::Handles)
        return;
    if (m_drag && m_viewport->input()->mode() == PointerMode::Sculpt) {
        cancelDrag();
        m_viewport->input()->setMode(PointerMode::Handles);
        return;
    }
    cancelDrag();
    setFrame({});
    Q_EMIT ended();
}

void Gizmo::cancelDrag()
{
    if (!m_drag)
        return;
    m_drag.reset();
    m_releaseFollows = true;
    m_frame = m_start;
    update();
    if (m_movesFrameOnly)
        Q_EMIT frameMoved();
    else
        Q_EMIT dropped({});
}

bool Gizmo::eventFilter(QObject* watched, QEvent* event)
{
    if (!m_frame)
        return false;
    if (const QSinglePointEvent* pointer = pointerEventIn(*event); pointer && handlePointer(*pointer)) {
        event->accept();
        return true;
    }
    switch (event->type()) {
    case QEvent::Wheel:
        return isDragging();
    case QEvent::ShortcutOverride: // claims the keys of a drag, which would otherwise trigger actions
    case QEvent::KeyPress:
        if (handleKey(*static_cast<QKeyEvent*>(event))) {
            event->accept();
            return true;
        }
        break;
    case QEvent::Resize:
        setGeometry(m_viewport->rect());
        break;
    case QEvent::Hide:
    case QEvent::WindowBlocked:
        cancelDrag();
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

bool Gizmo::handleKey(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Escape) // when its press comes here, it has taken back the drag
        return event.type() == QEvent::ShortcutOverride ? isDragging() : m_releaseFollows;
    const int axis = event.key() - Qt::Key_X;
    if (!m_drag || axis < 0 || axis > 2)
        return false;
    if (event.type() == QEvent::KeyPress) {
        m_drag->lockTo(axis);
        moveTo(m_pointer, event.modifiers());
    }
    return true;
}

/// Handles a pointer event; returns true if it is consumed.
bool Gizmo::handlePointer(const QSinglePointEvent& event)
{
    if (event.isEndEvent() && std::exchange(m_releaseFollows, false))
        return true;
    if (isPress(event))
        return press(event);
    if (m_drag && event.isUpdateEvent())
        moveTo(event.position(), event.modifiers());
    else if (m_drag && event.button() == Qt::LeftButton)
        drop();
    else if (event.isUpdateEvent() && event.buttons() == Qt::NoButton)
        setHot(shape().handleAt(event.position()));
    return m_drag.has_value() || m_hot.has_value();
}

bool Gizmo::press(const QSinglePointEvent& event)
{
    if (m_drag && event.button() == Qt::RightButton)
        cancelDrag();
    if (m_drag || (m_releaseFollows && event.button() != Qt::LeftButton))
        return true;
    m_releaseFollows = false;
    const std::optional<GizmoHandle> handle = shape().handleAt(event.position());
    if (!isEnabled() || !handle || event.button() != Qt::LeftButton)
        return false;
    setHot(handle);
    m_start = *m_frame;
    m_movesFrameOnly = event.modifiers() & Qt::AltModifier;
    m_pointer = event.position();
    m_by = {};
    m_drag.emplace(m_viewport->camera(), m_start, *handle, m_pointer);
    m_viewport->input()->pointerLeft();
    m_viewport->setFocus();
    update();
    return true;
}

void Gizmo::moveTo(const QPointF& pointer, Qt::KeyboardModifiers modifiers)
{
    m_pointer = pointer;
    m_by = m_drag->to(pointer, modifiers & Qt::ControlModifier);
    m_frame = moved(m_start, m_by);
    update();
    if (m_movesFrameOnly)
        Q_EMIT frameMoved();
    else
        Q_EMIT dragged(m_by);
}

void Gizmo::drop()
{
    m_drag.reset();
    m_frame = moved(m_start, m_by);
    update();
    if (m_movesFrameOnly)
        Q_EMIT frameMoved();
    else
        Q_EMIT dropped(m_by);
}

void Gizmo::setHot(std::optional<GizmoHandle> handle)
{
    if (std::exchange(m_hot, handle) == handle)
        return;
    m_viewport->setCursor(handle ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

GizmoShape Gizmo::shape() const
{
    return GizmoShape(m_viewport->camera(), *m_frame, m_handles);
}

/// Draws the square or its mirror image, unless a corner is behind the eye.
void Gizmo::paintPlane(QPainter& painter, core::Symmetry image) const
{
    const core::Vec3 mirror = core::planeNormal(image);
    const OrbitCamera& camera = m_viewport->camera();
    QPolygonF corners;
    for (const auto& [x, z] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        core::Vec3 corner = m_frame->centre + m_plane * (x * m_frame->axis(0) + z * m_frame->axis(2));
        corner -= 2 * mirror.dot(corner) * mirror;
        if (camera.projection() == OrbitCamera::Projection::Perspective &&
            (corner - camera.eye()).dot(camera.viewDirection()) <= camera.nearPlane())
            return;
        const OrbitCamera::Pixel at = camera.project(corner);
        corners << QPointF(at.x(), at.y());
    }
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isImage = image != core::Symmetry::None;
    painter.setBrush(QColor(120, 160, 230, isImage ? 20 : 34));
    painter.setPen(QPen(QColor(20, 22, 26, isImage ? 60 : 130), 2.4));
    painter.drawPolygon(corners);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(226, 234, 248, isImage ? 120 : 255), 1.1));
    painter.drawPolygon(corners);
}

/// Draws the handles, during a drag only the dragged one.
void Gizmo::paintEvent(QPaintEvent*)
{
    if (!m_frame)
        return;
    m_view = m_viewport->camera().projectionMatrix() * m_viewport->camera().viewMatrix();
    QPainter painter(this);
    painter.setOpacity(isEnabled() ? 1 : 0.4);
    if (m_plane > 0 && m_image != core::Symmetry::None)
        paintPlane(painter, m_image);
    if (m_plane > 0)
        paintPlane(painter, core::Symmetry::None);
    const std::optional<GizmoHandle> dragged = m_drag ? std::optional(m_drag->handle()) : std::nullopt;
    shape().paint(painter, m_drag ? dragged : m_hot, dragged);
}
} // namespace ui
