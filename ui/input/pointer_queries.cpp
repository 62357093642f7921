// What the hand asks about the surface, and what it makes of the answers.

#include "ui/input/pointer_input.h"

namespace ui
{
namespace
{
/// The place that the model's turn brought to where `hit` was.
core::SurfaceHit leftBehind(core::SurfaceHit hit, double angle)
{
    const Eigen::AngleAxisd back(-angle, core::Vec3::UnitY());
    hit.position = back * hit.position;
    hit.normal = back * hit.normal;
    return hit;
}
} // namespace

/// What is seen and done is that the model turns; in the model's space, where everything is kept, camera and hand go
/// the other way.
void PointerInput::turnModel(double angle, double seconds)
{
    m_camera->turnModel(angle);
    m_stroke.turnModel(angle, seconds);
    if (m_hit)
        m_hit = leftBehind(*m_hit, angle);
    Q_EMIT viewChanged();
    askAgain();
}

void PointerInput::askAgain()
{
    if (m_inside && m_waiting.empty() && (m_drag == Drag::None || m_drag == Drag::Stroke))
        ask({brushAt(), m_camera->ray(brushAt())});
}

void PointerInput::brushChanged()
{
    if (m_brush->stroke().brush == core::BrushShape::Ray && m_drag == Drag::None)
        askAgain();
}

void PointerInput::forgetHover()
{
    ++m_view;
    m_stroke.forgetTurn();
    m_answeredPixel.reset();
    m_hit.reset();
    m_footprint.reset();
    Q_EMIT hoverChanged();
    askAgain();
}

/// At most one question is in flight; of those that wait the newest counts, but a press's is never displaced.
void PointerInput::ask(Question question)
{
    question.view = m_view;
    question.turned = m_stroke.turned();
    if (!m_inFlight) {
        m_inFlight = question;
        put(question);
    } else if (!m_next || !m_next->forPress || question.forPress) {
        m_next = question;
    }
}

/// What a brush would take is of no use to a press, which shall be answered soon, and in a stroke.
void PointerInput::put(const Question& question)
{
    const core::StrokeSettings settings = m_brush->stroke();
    const bool wanted =
        settings.brush == core::BrushShape::Ray && !question.forPress && !m_holds && m_drag == Drag::None;
    Q_EMIT hoverRequested(question.ray, wanted ? std::optional(settings) : std::nullopt);
}

void PointerInput::setHover(const std::optional<core::SurfaceHit>& hit,
                            const std::shared_ptr<const core::Footprint>& footprint)
{
    if (!m_inFlight)
        return;
    const Question answered = *m_inFlight;
    m_inFlight.reset();
    if (answered.view == m_view) {
        m_hit = hit;
        m_footprint = footprint;
        if (m_hit && m_stroke.turned() != answered.turned)
            m_hit = leftBehind(*m_hit, m_stroke.turned() - answered.turned);
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

/// A left press for the brush at a place that no answer is about.
bool PointerInput::isUndecided(const PointerEvent& event) const
{
    return event.kind == PointerEvent::Kind::Press && event.button == Qt::LeftButton &&
           viewDrag(event.button, event.modifiers, m_habits) == Drag::None && m_drag == Drag::None && !m_isAdding &&
           m_answeredPixel != event.pixel;
}

std::optional<core::SurfaceHit> PointerInput::hover() const
{
    if (m_isAdding && m_inside && !movesView())
        return core::SurfaceHit{m_camera->acrossPivot(m_camera->ray(m_last)), -m_camera->viewDirection(), 0,
                                core::noSlot};
    const bool next = m_drag == Drag::None && viewDrag(Qt::LeftButton, m_modifiers, m_habits) != Drag::None;
    return m_inside && !m_holds && !movesView() && !next && !m_isPicking && !m_isPointing ? m_hit : std::nullopt;
}

std::optional<core::SurfaceHit> PointerInput::pointed() const
{
    return m_isPointing && m_inside && !m_holds && m_drag == Drag::None ? m_hit : std::nullopt;
}

bool PointerInput::wouldStroke() const
{
    return m_drag == Drag::None && !m_isAdding && hover().has_value();
}

std::shared_ptr<const core::Footprint> PointerInput::footprint() const
{
    return wouldStroke() ? m_footprint : nullptr;
}
} // namespace ui
