#include "ui/input/pointer_input.h"

#include <cmath>
#include <utility>

namespace ui
{
namespace
{
constexpr double zoomPerHeight = 0.1; ///< a zooming drag over the view's height comes so much nearer
constexpr double samePixel = 1;       ///< how far a known point may lie from the pointer and still be what is under it
} // namespace

PointerInput::PointerInput(const BrushSettings* brush, OrbitCamera* camera, QObject* parent)
    : QObject(parent)
    , m_brush(brush)
    , m_camera(camera)
    , m_stroke(brush, camera)
{
    connect(&m_stroke, &StrokeMaker::began, this, &PointerInput::strokeBegan);
    connect(&m_stroke, &StrokeMaker::sampled, this, &PointerInput::strokeSampled);
    connect(&m_stroke, &StrokeMaker::ended, this, &PointerInput::strokeEnded);
}

void PointerInput::setHabits(const HandHabits& habits)
{
    m_habits = habits;
    m_stroke.setHabits(habits);
}

void PointerInput::handle(const PointerEvent& event)
{
    Waiting waiting{event, m_camera->ray(event.pixel), {}};
    if (event.kind == PointerEvent::Kind::Press) {
        waiting.settings = strokeFor(event.modifiers, event.isEraser);
        waiting.string = m_brush->isSteady() ? m_brush->stringLength() : 0;
    }
    m_inside = true;
    m_holds = false;
    m_modifiers = event.modifiers;
    m_isEraser = event.isEraser;
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
    takeView();
}

void PointerInput::pan(const OrbitCamera::Pixel& delta)
{
    m_camera->pan(delta);
    takeView();
}

void PointerInput::orbit(const OrbitCamera::Pixel& delta)
{
    m_camera->orbit(delta);
    takeView();
}

void PointerInput::hold(const OrbitCamera::Pixel& pixel)
{
    m_inside = m_holds = true;
    m_last = pixel;
    askAgain();
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

void PointerInput::leave()
{
    m_inside = m_holds = false;
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

std::optional<PointerInput::String> PointerInput::string() const
{
    return strokeOpen() ? std::optional(String{m_stroke.handAt(), m_stroke.brushAt()}) : std::nullopt;
}

void PointerInput::setPicking(bool on)
{
    if (std::exchange(m_isPicking, on) == on)
        return;
    if (on) {
        setAdding(false);
        setPointing(false);
    }
    Q_EMIT pickingChanged(on);
    Q_EMIT hoverChanged();
}

void PointerInput::setPointing(bool on)
{
    if (std::exchange(m_isPointing, on) == on)
        return;
    if (on) {
        setAdding(false);
        setPicking(false);
    }
    Q_EMIT pointingChanged(on);
    Q_EMIT hoverChanged();
}

core::StrokeSettings PointerInput::stroke() const
{
    return strokeOpen() ? m_stroke.settings() : strokeFor(m_modifiers, m_isEraser);
}

/// Where the tool follows the hand, it follows every reading of it. The key that smooths does not where Smooth is not
/// offered.
core::StrokeSettings PointerInput::strokeFor(Qt::KeyboardModifiers modifiers, bool eraser) const
{
    modifiers.setFlag(Qt::ShiftModifier,
                      modifiers.testFlag(Qt::ShiftModifier) && m_brush->isOffered(core::Tool::Smooth));
    core::StrokeSettings stroke = withKeysHeld(m_brush->stroke(), modifiers, m_habits.held.invert);
    if (eraser != m_brush->isTurnedRound())
        stroke = core::opposite(stroke);
    if (core::isDragTool(stroke.tool))
        stroke.spacing = 0;
    return stroke;
}

/// Where the brush is, or would be.
OrbitCamera::Pixel PointerInput::brushAt() const
{
    return strokeOpen() ? m_stroke.brushAt() : m_last;
}

bool PointerInput::movesView() const
{
    return m_drag == Drag::Orbit || m_drag == Drag::Pan || m_drag == Drag::Zoom;
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
        m_stroke.comeTo(waiting.event.pixel, waiting.event.time);
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
    return m_isAdding && press.button == Qt::LeftButton &&
           viewDrag(press.button, press.modifiers, m_habits) == Drag::None;
}

void PointerInput::addSphere(const Waiting& press)
{
    core::StrokeSample sample;
    sample.time = press.event.time;
    sample.position = m_camera->acrossPivot(press.ray);
    sample.direction = press.ray.direction;
    setAdding(false);
    Q_EMIT sphereRequested(addingDab(press.settings), sample);
}

void PointerInput::setAdding(bool adding)
{
    if (std::exchange(m_isAdding, adding) == adding)
        return;
    if (adding) {
        setPicking(false);
        setPointing(false);
    }
    Q_EMIT addingChanged(adding);
    Q_EMIT hoverChanged();
}

void PointerInput::begin(const Waiting& press, const std::optional<core::SurfaceHit>& hit)
{
    m_drag = viewDrag(press.event.button, press.event.modifiers, m_habits);
    if (m_drag == Drag::None && press.event.button == Qt::LeftButton && m_isPicking) {
        setPicking(false);
        Q_EMIT picked(hit);
        return;
    }
    if (m_drag == Drag::None && press.event.button == Qt::LeftButton && m_isPointing && hit)
        return;
    if (m_drag == Drag::None && press.event.button == Qt::LeftButton)
        m_drag = hit ? Drag::Stroke : dragBesideModel(press.event.modifiers, m_habits);
    if (m_drag == Drag::None)
        return;
    m_dragButton = press.event.button;
    m_pressed = m_last = press.event.pixel;
    if (m_drag == Drag::Stroke) {
        m_camera->setPivot(hit->position);
        m_footprint.reset();
        m_stroke.begin({press.event, press.ray, press.settings, press.string});
    } else if (m_drag != Drag::Orbit) {
        goByDepthAt(m_pressed);
    }
    Q_EMIT hoverChanged();
}

void PointerInput::end()
{
    const Drag ended = std::exchange(m_drag, Drag::None);
    m_dragButton = Qt::NoButton;
    if (ended == Drag::None)
        return;
    if (ended == Drag::Stroke)
        m_stroke.end();
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
        m_stroke.follow(waiting.event, waiting.ray);
    const OrbitCamera::Pixel at = m_drag == Drag::Stroke ? m_stroke.brushAt() : waiting.event.pixel;
    ask({at, m_camera->ray(at)});
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
    takeView();
}

void PointerInput::takeView()
{
    Q_EMIT viewTaken();
    viewMoved();
}
} // namespace ui
