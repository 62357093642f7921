#include "ui/input/pointer_input.h"

#include <cmath>
#include <utility>

namespace ui
{
namespace
{
constexpr double zoomPerHeight = 0.1; ///< factor on the distance for a zoom drag over the whole height of the view
constexpr double clickDistance = 4;   ///< pixels; largest motion of the pointer during a click
constexpr double samePixel = 1;       ///< pixels; largest distance at which a known hit counts as under the pointer
} // namespace

PointerInput::PointerInput(const BrushSettings* brush, OrbitCamera* camera, QObject* parent)
    : QObject(parent)
    , m_brush(brush)
    , m_camera(camera)
    , m_stroke(brush, camera)
{
    connect(&m_query, &HoverQuery::sent, this, &PointerInput::sendQuery);
    connect(&m_stroke, &StrokeBuilder::began, this, &PointerInput::strokeBegan);
    connect(&m_stroke, &StrokeBuilder::sampled, this, &PointerInput::strokeSampled);
    connect(&m_stroke, &StrokeBuilder::ended, this, &PointerInput::strokeEnded);
}

void PointerInput::setInputPreferences(const InputPreferences& preferences)
{
    m_preferences = preferences;
    m_stroke.setInputPreferences(preferences);
}

void PointerInput::handle(const PointerEvent& event)
{
    PendingEvent pending{event, m_camera->ray(event.pixel), {}};
    if (event.kind == PointerEvent::Kind::Press) {
        pending.settings = strokeFor(event.modifiers, event.isEraser);
        pending.stabilizerLength = m_brush->isSteady() ? m_brush->stabilizerLength() : 0;
    }
    m_inside = true;
    m_isGesture = false;
    m_modifiers = event.modifiers;
    m_isEraser = event.isEraser;
    if (!m_pending.empty()) {
        m_pending.push_back(pending);
    } else if (isUndecided(event)) {
        m_pending.push_back(pending);
        m_query.request(event.pixel, pending.ray, true);
    } else {
        process(pending);
    }
}

void PointerInput::zoom(double factor, const OrbitCamera::Pixel& toward)
{
    setTargetDepthAt(toward);
    m_camera->zoom(factor, toward);
    emitViewMovedByUser();
}

void PointerInput::pan(const OrbitCamera::Pixel& delta)
{
    m_camera->pan(delta);
    emitViewMovedByUser();
}

void PointerInput::orbit(const OrbitCamera::Pixel& delta)
{
    m_camera->orbit(delta);
    emitViewMovedByUser();
}

void PointerInput::setGestureCenter(const OrbitCamera::Pixel& pixel)
{
    m_inside = m_isGesture = true;
    m_last = pixel;
    refreshHover();
}

/// Sets the depth for panning and zooming to that of the surface under the pixel, if known. The surface then follows
/// the pointer, and zooming cannot pass through it.
void PointerInput::setTargetDepthAt(const OrbitCamera::Pixel& pixel)
{
    const std::optional<core::SurfaceHit>& hit = m_query.hit();
    if (m_inside && hit && (m_camera->project(hit->position) - pixel).norm() <= samePixel)
        m_camera->setTargetDepth(hit->position);
}

void PointerInput::viewMoved()
{
    m_query.viewMoved();
    Q_EMIT viewChanged();
    refreshHover();
}

void PointerInput::pointerLeft()
{
    m_inside = m_isGesture = false;
    m_query.dropNext();
    Q_EMIT hoverChanged();
}

void PointerInput::finish(core::StrokeEnd how)
{
    if (!m_pending.empty() && m_pending.back().event.kind != PointerEvent::Kind::Release) {
        PendingEvent release = m_pending.back();
        release.event.kind = PointerEvent::Kind::Release;
        release.event.button = m_pending.front().event.button;
        m_pending.push_back(release);
    }
    end(how);
}

void PointerInput::setModifiers(Qt::KeyboardModifiers modifiers)
{
    if (m_modifiers == modifiers)
        return;
    m_modifiers = modifiers;
    Q_EMIT hoverChanged();
}

std::optional<PointerInput::Stabilizer> PointerInput::stabilizer() const
{
    if (!strokeOpen())
        return std::nullopt;
    return Stabilizer{m_stroke.pointerAt(), m_anchor ? m_pressed : m_stroke.brushAt()};
}

void PointerInput::setMode(PointerMode mode, bool on)
{
    const PointerMode next = on ? mode : m_mode == mode ? PointerMode::Sculpt : m_mode;
    if (std::exchange(m_mode, next) == next)
        return;
    Q_EMIT modeChanged(next);
    Q_EMIT hoverChanged();
}

core::StrokeSettings PointerInput::stroke() const
{
    return strokeOpen() ? m_stroke.settings() : strokeFor(m_modifiers, m_isEraser);
}

/// Returns the settings of a stroke with these modifier keys. Drag tools sample every event (spacing 0). Shift is
/// ignored if Smooth is not offered.
core::StrokeSettings PointerInput::strokeFor(Qt::KeyboardModifiers modifiers, bool eraser) const
{
    modifiers.setFlag(Qt::ShiftModifier,
                      modifiers.testFlag(Qt::ShiftModifier) && m_brush->isOffered(core::Tool::Smooth));
    core::StrokeSettings stroke = withModifiers(*m_brush, modifiers, m_preferences.modifiers.invert);
    if (eraser != m_brush->isInverted())
        stroke = core::opposite(stroke);
    if (core::isDragTool(stroke.tool))
        stroke.spacing = 0;
    stroke.airbrush = core::isAnchored(stroke) ? 0 : m_brush->tools()->airbrush(stroke.tool);
    return stroke;
}

/// Returns the pixel of the brush: in an open stroke its own, else the pointer's.
OrbitCamera::Pixel PointerInput::brushAt() const
{
    return strokeOpen() ? m_stroke.brushAt() : m_last;
}

bool PointerInput::movesView() const
{
    return m_drag == Drag::Orbit || m_drag == Drag::Pan || m_drag == Drag::Zoom;
}

void PointerInput::process(const PendingEvent& pending)
{
    switch (pending.event.kind) {
    case PointerEvent::Kind::Press:
        press(pending, m_query.hit());
        break;
    case PointerEvent::Kind::Move:
        move(pending);
        break;
    case PointerEvent::Kind::Release:
        if (pending.event.button != m_dragButton)
            break;
        m_stroke.setReleasePoint(pending.event.pixel, pending.event.time);
        release(pending.event);
        break;
    }
    m_last = pending.event.pixel;
}

/// Ends the drag. A click of the right button without modifier keys requests the palette.
void PointerInput::release(const PointerEvent& event)
{
    const bool isClick = movesView() && !m_hasMoved;
    end();
    if (isClick && event.button == Qt::RightButton && !event.modifiers)
        Q_EMIT paletteRequested(event.pixel);
    if (isClick && event.button == Qt::LeftButton && event.modifiers == Qt::AltModifier)
        Q_EMIT partPicked(m_camera->ray(event.pixel));
}

/// Handles a press. During a stroke, the right button cancels the stroke; other presses during a drag are ignored.
void PointerInput::press(const PendingEvent& pending, const std::optional<core::SurfaceHit>& hit)
{
    if (m_drag == Drag::Stroke && pending.event.button == Qt::RightButton)
        return finish(core::StrokeEnd::TakenBack);
    if (m_drag != Drag::None)
        return;
    if (m_mode == PointerMode::Add && isForBrush(pending.event))
        addSphere(pending, hit);
    else
        begin(pending, hit);
}

/// Returns true if the press is for the brush: left button, without modifier keys that move the view.
bool PointerInput::isForBrush(const PointerEvent& press) const
{
    return press.button == Qt::LeftButton && viewDrag(press.button, press.modifiers, m_preferences) == Drag::None;
}

/// Requests a ball on the surface; beside the model, the ball is at the depth of the camera's pivot.
void PointerInput::addSphere(const PendingEvent& press, const std::optional<core::SurfaceHit>& hit)
{
    core::StrokeSample sample;
    sample.time = press.event.time;
    sample.position = hit ? hit->position : m_camera->acrossPivot(press.ray);
    sample.direction = press.ray.direction;
    setMode(PointerMode::Sculpt);
    Q_EMIT sphereRequested(core::addingSolid(press.settings), sample);
}

void PointerInput::begin(const PendingEvent& press, const std::optional<core::SurfaceHit>& hit)
{
    if (isForBrush(press.event)) {
        if (m_mode == PointerMode::Pick) {
            setMode(PointerMode::Sculpt);
            Q_EMIT picked(hit);
            return;
        }
        if (m_mode == PointerMode::ChoosePart) {
            setMode(PointerMode::Sculpt);
            Q_EMIT partPicked(press.ray);
            return;
        }
        if (m_mode == PointerMode::Point && hit)
            return;
        m_drag = hit && m_mode != PointerMode::Handles ? Drag::Stroke
                                                       : dragBesideModel(press.event.modifiers, m_preferences);
    } else {
        m_drag = viewDrag(press.event.button, press.event.modifiers, m_preferences);
    }
    if (m_drag == Drag::None)
        return;
    m_dragButton = press.event.button;
    m_pressed = m_last = press.event.pixel;
    m_hasMoved = false;
    if (m_drag == Drag::Stroke) {
        m_camera->setPivot(hit->position);
        m_query.clearFootprint();
        m_anchor = core::isAnchored(press.settings) ? hit : std::nullopt;
        m_stroke.begin({press.event, press.ray, press.settings, m_anchor ? 0 : press.stabilizerLength});
    } else if (m_drag != Drag::Orbit) {
        setTargetDepthAt(m_pressed);
    }
    Q_EMIT hoverChanged();
}

void PointerInput::end(core::StrokeEnd how)
{
    const Drag ended = std::exchange(m_drag, Drag::None);
    m_dragButton = Qt::NoButton;
    if (ended == Drag::None)
        return;
    if (ended == Drag::Stroke)
        m_stroke.end(how);
    Q_EMIT hoverChanged();
    if (m_pending.empty())
        refreshHover();
}

void PointerInput::move(const PendingEvent& pending)
{
    if (movesView()) {
        m_hasMoved = m_hasMoved || (pending.event.pixel - m_pressed).norm() > clickDistance;
        moveView(pending.event.pixel - m_last);
        return;
    }
    if (m_drag == Drag::Stroke)
        m_stroke.moveTo(pending.event, pending.ray);
    const OrbitCamera::Pixel at = m_drag == Drag::Stroke ? m_stroke.brushAt() : pending.event.pixel;
    m_query.request(at, m_camera->ray(at));
}

/// Moves the view. A zoom drag to the right or upwards zooms in on the pixel at which it began.
void PointerInput::moveView(const OrbitCamera::Pixel& delta)
{
    const double nearer = (delta.x() - delta.y()) / m_camera->viewport().y();
    if (m_drag == Drag::Pan)
        m_camera->pan(delta);
    else if (m_drag == Drag::Zoom)
        m_camera->zoom(std::pow(zoomPerHeight, nearer), m_pressed);
    else
        m_camera->orbit(delta);
    emitViewMovedByUser();
}

void PointerInput::emitViewMovedByUser()
{
    Q_EMIT viewMovedByUser();
    viewMoved();
}

/// Turns the model on the screen. All data is in model space, so camera and pointer are turned the other way.
void PointerInput::turnModel(double angle, double seconds)
{
    m_camera->turnModel(angle);
    m_stroke.turnModel(angle, seconds);
    m_query.turnModel(angle);
    Q_EMIT viewChanged();
    refreshHover();
}

void PointerInput::refreshHover()
{
    if (m_inside && m_pending.empty() && (m_drag == Drag::None || m_drag == Drag::Stroke))
        m_query.request(brushAt(), m_camera->ray(brushAt()));
}

void PointerInput::brushChanged()
{
    if (m_brush->stroke().brush == core::BrushShape::Ray && m_drag == Drag::None)
        refreshHover();
}

void PointerInput::clearHover()
{
    m_stroke.resetTurn();
    m_query.clear();
    Q_EMIT hoverChanged();
    refreshHover();
}

/// Emits hoverRequested(). A footprint is not requested for presses, whose answer is urgent, or during drags and
/// gestures, which do not show it.
void PointerInput::sendQuery(const HoverQuery::Request& request)
{
    const core::StrokeSettings settings = m_brush->stroke();
    const bool wanted =
        settings.brush == core::BrushShape::Ray && !request.isForPress && !m_isGesture && m_drag == Drag::None;
    Q_EMIT hoverRequested(request.ray, wanted ? std::optional(settings) : std::nullopt);
}

void PointerInput::setHover(const std::optional<core::SurfaceHit>& hit,
                            const std::shared_ptr<const core::Footprint>& footprint)
{
    const std::optional<HoverQuery::Request> answered = m_query.takeAnswer(hit, footprint);
    if (!answered)
        return;
    if (m_drag == Drag::Stroke && hit)
        m_camera->setPivot(hit->position);
    if (answered->isForPress) {
        processPending(hit);
        Q_EMIT pressDecided();
    }
    m_query.sendNext();
    Q_EMIT hoverChanged();
}

/// Processes the front press, whose hit is now known, and the events after it, up to the next press that needs an
/// answer.
void PointerInput::processPending(const std::optional<core::SurfaceHit>& hit)
{
    std::deque<PendingEvent> events;
    events.swap(m_pending);
    press(events.front(), hit);
    events.pop_front();
    while (!events.empty()) {
        const PendingEvent pending = events.front();
        if (isUndecided(pending.event)) {
            m_pending.swap(events);
            m_query.request(pending.event.pixel, pending.ray, true);
            return;
        }
        events.pop_front();
        process(pending);
    }
}

/// Returns true for a press of the brush at a pixel for which there is no answer yet.
bool PointerInput::isUndecided(const PointerEvent& event) const
{
    return event.kind == PointerEvent::Kind::Press && isForBrush(event) && m_drag == Drag::None &&
           !m_query.isAbout(event.pixel);
}

std::optional<core::SurfaceHit> PointerInput::hover() const
{
    if (strokeOpen() && m_anchor)
        return m_anchor;
    if (!m_inside || movesView())
        return {};
    if (m_mode == PointerMode::Add && m_query.hit())
        return m_query.hit();
    if (m_mode == PointerMode::Add)
        return core::SurfaceHit{m_camera->acrossPivot(m_camera->ray(m_last)), -m_camera->viewDirection(), 0,
                                core::noSlot};
    const bool next = m_drag == Drag::None && viewDrag(Qt::LeftButton, m_modifiers, m_preferences) != Drag::None;
    return !m_isGesture && !next && m_mode == PointerMode::Sculpt ? m_query.hit() : std::nullopt;
}

std::optional<core::SurfaceHit> PointerInput::pointed() const
{
    return m_mode == PointerMode::Point && m_inside && !m_isGesture && m_drag == Drag::None ? m_query.hit()
                                                                                            : std::nullopt;
}

bool PointerInput::wouldStroke() const
{
    return m_drag == Drag::None && m_mode != PointerMode::Add && hover().has_value();
}

std::shared_ptr<const core::Footprint> PointerInput::footprint() const
{
    return wouldStroke() ? m_query.footprint() : nullptr;
}

double PointerInput::pixelsPerMm() const
{
    const std::optional<core::SurfaceHit> hit = hover();
    return m_camera->pixelsPerMm(hit ? hit->position : m_camera->pivot());
}
} // namespace ui
