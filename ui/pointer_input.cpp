#include "pointer_input.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ui
{
namespace
{
constexpr double zoomPerHeight = 0.1; ///< a zooming drag over the view's height comes so much nearer
constexpr double leastRadiusShare = 0.1; ///< of the brush, under the lightest touch
constexpr double samePixel = 1;       ///< how far a known point may lie from the pointer and still be what is under it

Eigen::Quaterniond aboutY(double angle)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, core::Vec3::UnitY()));
}

/// The place that the model's turn brought to where `hit` was.
core::SurfaceHit leftBehind(core::SurfaceHit hit, double angle)
{
    hit.position = aboutY(-angle) * hit.position;
    hit.normal = aboutY(-angle) * hit.normal;
    return hit;
}
} // namespace

PointerInput::PointerInput(const BrushSettings* brush, OrbitCamera* camera, QObject* parent)
    : QObject(parent)
    , m_brush(brush)
    , m_camera(camera)
{}

void PointerInput::handle(const PointerEvent& event)
{
    Waiting waiting{event, m_camera->ray(event.pixel), {}};
    if (event.kind == PointerEvent::Kind::Press) {
        waiting.settings = m_brush->stroke();
        waiting.settings.tool = toolWith(m_brush->tool(), event.modifiers);
        waiting.string = m_brush->isSteady() ? m_brush->stringLength() : 0;
    }
    m_inside = true;
    m_modifiers = event.modifiers;
    if (!m_waiting.empty()) {
        m_waiting.push_back(waiting);
    } else if (isUndecided(event)) {
        m_waiting.push_back(waiting);
        ask({event.pixel, waiting.ray, true});
    } else {
        process(waiting);
    }
}

void PointerInput::zoom(double factor, const OrbitCamera::Pixel& toward)
{
    goByDepthAt(toward);
    m_camera->zoom(factor, toward);
    viewMoved();
}

void PointerInput::pan(const OrbitCamera::Pixel& delta)
{
    m_camera->pan(delta);
    viewMoved();
}

/// Where the surface under the pixel is known, it is what panning and zooming hold: the view never runs through it.
void PointerInput::goByDepthAt(const OrbitCamera::Pixel& pixel)
{
    if (m_inside && m_hit && (m_camera->project(m_hit->position) - pixel).norm() <= samePixel)
        m_camera->setTargetDepth(m_hit->position);
}

void PointerInput::viewMoved()
{
    ++m_view;
    m_answeredPixel.reset();
    Q_EMIT viewChanged();
    askAgain();
}

/// What is seen and done is that the model turns; in the model's space, where everything is kept, camera and hand go the other way.
void PointerInput::turnModel(double angle, double seconds)
{
    m_camera->turnModel(angle);
    m_turned = std::remainder(m_turned + angle, 2 * std::numbers::pi);
    if (m_hit)
        m_hit = leftBehind(*m_hit, angle);
    if (m_drag == Drag::Stroke) {
        m_hand.time += seconds;
        sample({m_hand, m_camera->ray(m_brushAt), {}});
    }
    Q_EMIT viewChanged();
    askAgain();
}

void PointerInput::leave()
{
    m_inside = false;
    if (m_next && !m_next->forPress)
        m_next.reset();
    Q_EMIT hoverChanged();
}

void PointerInput::finish()
{
    if (!m_waiting.empty() && m_waiting.back().event.kind != PointerEvent::Kind::Release) {
        Waiting release = m_waiting.back();
        release.event.kind = PointerEvent::Kind::Release;
        release.event.button = m_waiting.front().event.button;
        m_waiting.push_back(release);
    }
    end();
}

void PointerInput::setModifiers(Qt::KeyboardModifiers modifiers)
{
    if (m_modifiers == modifiers)
        return;
    m_modifiers = modifiers;
    Q_EMIT hoverChanged();
}

void PointerInput::askAgain()
{
    if (m_inside && m_waiting.empty() && (m_drag == Drag::None || m_drag == Drag::Stroke))
        ask(m_drag == Drag::Stroke ? Question{m_brushAt, m_camera->ray(m_brushAt)} : Question{m_last, m_camera->ray(m_last)});
}

void PointerInput::forgetHover()
{
    ++m_view;
    m_turned = 0;
    m_answeredPixel.reset();
    m_hit.reset();
    Q_EMIT hoverChanged();
    askAgain();
}

void PointerInput::setHover(const std::optional<core::SurfaceHit>& hit)
{
    if (!m_inFlight)
        return;
    const Question answered = *m_inFlight;
    m_inFlight.reset();
    if (answered.view == m_view) {
        m_hit = hit;
        if (m_hit && m_turned != answered.turned)
            m_hit = leftBehind(*m_hit, m_turned - answered.turned);
        m_answeredPixel = answered.pixel;
    }
    if (m_drag == Drag::Stroke && hit)
        m_camera->setPivot(hit->position);
    if (answered.forPress) {
        drain(hit);
        Q_EMIT pressDecided();
    }
    if (m_next && !m_inFlight) {
        const Question next = *m_next;
        m_next.reset();
        ask(next);
    }
    Q_EMIT hoverChanged();
}

std::optional<core::SurfaceHit> PointerInput::hover() const
{
    if (m_isAdding && m_inside && !movesView())
        return core::SurfaceHit{spherePlace(m_camera->ray(m_last)), -m_camera->viewDirection(), 0, core::noSlot};
    const bool next = m_drag == Drag::None && viewDrag(Qt::LeftButton, m_modifiers) != Drag::None;
    return m_inside && !movesView() && !next && !m_isPicking ? m_hit : std::nullopt;
}

void PointerInput::setPicking(bool on)
{
    if (std::exchange(m_isPicking, on) == on)
        return;
    if (on)
        setAdding(false);
    Q_EMIT pickingChanged(on);
    Q_EMIT hoverChanged();
}

core::Tool PointerInput::tool() const
{
    return strokeOpen() ? m_strokeTool : toolWith(m_brush->tool(), m_modifiers);
}

/// How a press moves the view, wherever it is; None: it does not, or that depends on what is under it.
PointerInput::Drag PointerInput::viewDrag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) const
{
    struct Row
    {
        Qt::MouseButton button;
        Qt::KeyboardModifier held;
        Drag drag;
    };
    static constexpr Row table[] = {
        {Qt::LeftButton, Qt::AltModifier, Drag::Orbit},      {Qt::MiddleButton, Qt::AltModifier, Drag::Pan},
        {Qt::RightButton, Qt::AltModifier, Drag::Zoom},      {Qt::MiddleButton, Qt::ShiftModifier, Drag::Pan},
        {Qt::MiddleButton, Qt::ControlModifier, Drag::Zoom}, {Qt::MiddleButton, Qt::NoModifier, Drag::Orbit},
        {Qt::RightButton, Qt::NoModifier, Drag::Pan},
    };
    if (!m_habits.altMovesView)
        modifiers &= ~Qt::KeyboardModifiers(Qt::AltModifier);
    for (const Row& row : table)
        if (row.button == button && (row.held == Qt::NoModifier || (modifiers & row.held)))
            return row.drag;
    return Drag::None;
}

bool PointerInput::movesView() const
{
    return m_drag == Drag::Orbit || m_drag == Drag::Pan || m_drag == Drag::Zoom;
}

/// A left press for the brush at a place that no answer is about.
bool PointerInput::isUndecided(const PointerEvent& event) const
{
    return event.kind == PointerEvent::Kind::Press && event.button == Qt::LeftButton &&
           viewDrag(event.button, event.modifiers) == Drag::None && m_drag == Drag::None && !m_isAdding &&
           m_answeredPixel != event.pixel;
}

/// At most one question is in flight; of those that wait the newest counts, but a press's is never displaced.
void PointerInput::ask(Question question)
{
    question.view = m_view;
    question.turned = m_turned;
    if (!m_inFlight) {
        m_inFlight = question;
        Q_EMIT hoverRequested(question.ray);
    } else if (!m_next || !m_next->forPress || question.forPress) {
        m_next = question;
    }
}

void PointerInput::process(const Waiting& waiting)
{
    switch (waiting.event.kind) {
    case PointerEvent::Kind::Press:
        press(waiting);
        break;
    case PointerEvent::Kind::Move:
        move(waiting);
        break;
    case PointerEvent::Kind::Release:
        if (waiting.event.button != m_dragButton)
            break;
        m_hand.pixel = waiting.event.pixel;
        m_hand.time = waiting.event.time;
        end();
        break;
    }
    m_last = waiting.event.pixel;
}

/// A second button during a drag means nothing.
void PointerInput::press(const Waiting& waiting)
{
    if (m_drag == Drag::None && addsSphere(waiting.event))
        addSphere(waiting);
    else if (m_drag == Drag::None)
        begin(waiting, m_hit);
}

bool PointerInput::addsSphere(const PointerEvent& press) const
{
    return m_isAdding && press.button == Qt::LeftButton && viewDrag(press.button, press.modifiers) == Drag::None;
}

void PointerInput::addSphere(const Waiting& press)
{
    core::StrokeSettings settings = press.settings;
    settings.tool = core::Tool::Pull;
    settings.brush = core::BrushShape::Sphere;
    settings.place = core::Placement::Point;
    settings.strength = core::info(core::Parameter::Strength).defaultValue;
    settings.spacing = 0;
    settings.add = true;
    core::StrokeSample sample;
    sample.time = press.event.time;
    sample.position = spherePlace(press.ray);
    sample.direction = press.ray.direction;
    setAdding(false);
    Q_EMIT sphereRequested(settings, sample);
}

/// In the plane that faces the camera through the last stroke, else through the scene's centre; through what is in the middle
/// of the view if that lies behind the eye.
core::Vec3 PointerInput::spherePlace(const core::Ray& ray) const
{
    const core::Vec3 normal = m_camera->viewDirection();
    const auto along = [&](const core::Vec3& point) { return (point - ray.origin).dot(normal) / ray.direction.dot(normal); };
    const double there = along(m_camera->pivot());
    return ray.origin + (there > 0 ? there : along(m_camera->target())) * ray.direction;
}

void PointerInput::setAdding(bool adding)
{
    if (std::exchange(m_isAdding, adding) == adding)
        return;
    if (adding)
        setPicking(false);
    Q_EMIT addingChanged(adding);
    Q_EMIT hoverChanged();
}

void PointerInput::begin(const Waiting& press, const std::optional<core::SurfaceHit>& hit)
{
    m_drag = viewDrag(press.event.button, press.event.modifiers);
    if (m_drag == Drag::None && press.event.button == Qt::LeftButton && m_isPicking) {
        setPicking(false);
        Q_EMIT picked(hit);
        return;
    }
    if (m_drag == Drag::None && press.event.button == Qt::LeftButton)
        m_drag = hit ? Drag::Stroke : Drag::Orbit;
    if (m_drag == Drag::None)
        return;
    m_dragButton = press.event.button;
    m_pressed = m_last = press.event.pixel;
    if (m_drag == Drag::Stroke) {
        m_strokeTool = press.settings.tool;
        m_strokeRadius = press.settings.radius;
        m_string = press.string;
        m_hand = press.event;
        m_brushAt = press.event.pixel;
        m_camera->setPivot(hit->position);
        Q_EMIT strokeBegan(press.settings);
        sample(press);
    } else if (m_drag != Drag::Orbit) {
        goByDepthAt(m_pressed);
    }
    Q_EMIT hoverChanged();
}

void PointerInput::end()
{
    if (m_drag == Drag::Stroke && m_string > 0 && m_brushAt != m_hand.pixel)
        sample({m_hand, m_camera->ray(m_hand.pixel), {}});
    const Drag ended = m_drag;
    m_drag = Drag::None;
    m_dragButton = Qt::NoButton;
    if (ended == Drag::None)
        return;
    if (ended == Drag::Stroke)
        Q_EMIT strokeEnded();
    Q_EMIT hoverChanged();
    if (m_waiting.empty())
        askAgain();
}

void PointerInput::move(const Waiting& waiting)
{
    if (movesView()) {
        moveView(waiting.event.pixel - m_last);
        return;
    }
    if (m_drag == Drag::Stroke)
        follow(waiting);
    const OrbitCamera::Pixel at = m_drag == Drag::Stroke ? m_brushAt : waiting.event.pixel;
    ask({at, m_camera->ray(at)});
}

/// The press at the front is decided; what came after it follows, up to the next press that needs an answer.
void PointerInput::drain(const std::optional<core::SurfaceHit>& hit)
{
    std::deque<Waiting> events;
    events.swap(m_waiting);
    begin(events.front(), hit);
    events.pop_front();
    while (!events.empty()) {
        const Waiting waiting = events.front();
        if (isUndecided(waiting.event)) {
            m_waiting.swap(events);
            ask({waiting.event.pixel, waiting.ray, true});
            return;
        }
        events.pop_front();
        process(waiting);
    }
}

/// The pointer draws the brush behind it when the string is taut.
void PointerInput::follow(const Waiting& waiting)
{
    m_hand = waiting.event;
    if (m_string == 0) {
        m_brushAt = waiting.event.pixel;
        return sample(waiting);
    }
    const OrbitCamera::Pixel way = waiting.event.pixel - m_brushAt;
    if (way.norm() <= m_string)
        return;
    m_brushAt = waiting.event.pixel - way.normalized() * m_string;
    Waiting drawn = waiting;
    drawn.ray = m_camera->ray(m_brushAt);
    sample(drawn);
}

void PointerInput::sample(const Waiting& waiting)
{
    core::StrokeSample sample;
    sample.time = waiting.event.time;
    sample.rotation = aboutY(m_turned);
    sample.position = sample.rotation * waiting.ray.origin;
    sample.direction = sample.rotation * waiting.ray.direction;
    const double pressure = waiting.event.pressure;
    sample.pressure = m_habits.pressureToStrength ? pressure : 1;
    if (m_habits.pressureToRadius)
        sample.radius = std::max(m_brush->minOf(core::Parameter::Radius), m_strokeRadius * std::max(pressure, leastRadiusShare));
    Q_EMIT strokeSampled(sample);
}

/// A zooming drag to the right or up comes nearer to where it began.
void PointerInput::moveView(const OrbitCamera::Pixel& delta)
{
    const double nearer = (delta.x() - delta.y()) / m_camera->viewport().y();
    if (m_drag == Drag::Pan)
        m_camera->pan(delta);
    else if (m_drag == Drag::Zoom)
        m_camera->zoom(std::pow(zoomPerHeight, nearer), m_pressed);
    else
        m_camera->orbit(delta);
    viewMoved();
}
} // namespace ui
