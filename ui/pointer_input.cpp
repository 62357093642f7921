#include "pointer_input.h"

namespace ui
{
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
    m_camera->zoom(factor, toward);
    viewMoved();
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
    m_inside = false;
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
        ask({m_last, m_camera->ray(m_last)});
}

void PointerInput::forgetHover()
{
    ++m_view;
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
        m_answeredPixel = answered.pixel;
    }
    if (answered.forPress) {
        drain(hit.has_value());
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
    const bool turning = m_drag == Drag::Orbit || m_drag == Drag::Pan;
    return m_inside && !turning ? m_hit : std::nullopt;
}

core::Tool PointerInput::tool() const
{
    return strokeOpen() ? m_strokeTool : toolWith(m_brush->tool(), m_modifiers);
}

/// A left press at a place that no answer is about.
bool PointerInput::isUndecided(const PointerEvent& event) const
{
    return event.kind == PointerEvent::Kind::Press && event.button == Qt::LeftButton && m_drag == Drag::None &&
           m_answeredPixel != event.pixel;
}

/// At most one question is in flight; of those that wait the newest counts, but a press's is never displaced.
void PointerInput::ask(Question question)
{
    question.view = m_view;
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
        if (waiting.event.button == m_dragButton)
            end();
        break;
    }
    m_last = waiting.event.pixel;
}

/// A second button during a drag means nothing.
void PointerInput::press(const Waiting& waiting)
{
    if (m_drag == Drag::None)
        begin(waiting, m_hit.has_value());
}

void PointerInput::begin(const Waiting& press, bool onModel)
{
    m_dragButton = press.event.button;
    m_last = press.event.pixel;
    if (press.event.button == Qt::LeftButton && onModel) {
        m_drag = Drag::Stroke;
        m_strokeTool = press.settings.tool;
        Q_EMIT strokeBegan(press.settings);
        sample(press);
    } else {
        const bool pans = press.event.button == Qt::RightButton ||
                          (press.event.button == Qt::MiddleButton && (press.event.modifiers & Qt::ShiftModifier));
        m_drag = pans ? Drag::Pan : Drag::Orbit;
    }
    Q_EMIT hoverChanged();
}

void PointerInput::end()
{
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
    if (m_drag == Drag::Orbit || m_drag == Drag::Pan) {
        turnView(waiting.event.pixel - m_last);
        return;
    }
    if (m_drag == Drag::Stroke)
        sample(waiting);
    ask({waiting.event.pixel, m_camera->ray(waiting.event.pixel)});
}

/// The press at the front is decided; what came after it follows, up to the next press that needs an answer.
void PointerInput::drain(bool onModel)
{
    std::deque<Waiting> events;
    events.swap(m_waiting);
    begin(events.front(), onModel);
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

void PointerInput::sample(const Waiting& waiting)
{
    core::StrokeSample sample;
    sample.time = waiting.event.time;
    sample.position = waiting.ray.origin;
    sample.direction = waiting.ray.direction;
    sample.pressure = waiting.event.pressure;
    Q_EMIT strokeSampled(sample);
}

void PointerInput::turnView(const OrbitCamera::Pixel& delta)
{
    if (m_drag == Drag::Pan)
        m_camera->pan(delta);
    else
        m_camera->orbit(delta);
    viewMoved();
}
} // namespace ui
