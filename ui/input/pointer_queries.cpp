// Hover queries: requests to the surface under the pointer, and what follows from their answers.

#include "ui/input/pointer_input.h"

namespace ui
{
namespace
{
/// Returns the place that the model's turn brought to where `hit` was.
core::SurfaceHit turnedBack(core::SurfaceHit hit, double angle)
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
        m_hit = turnedBack(*m_hit, angle);
    Q_EMIT viewChanged();
    refreshHover();
}

void PointerInput::refreshHover()
{
    if (m_inside && m_pending.empty() && (m_drag == Drag::None || m_drag == Drag::Stroke))
        requestHover({brushAt(), m_camera->ray(brushAt())});
}

void PointerInput::brushChanged()
{
    if (m_brush->stroke().brush == core::BrushShape::Ray && m_drag == Drag::None)
        refreshHover();
}

void PointerInput::clearHover()
{
    ++m_view;
    m_stroke.resetTurn();
    m_answeredPixel.reset();
    m_hit.reset();
    m_footprint.reset();
    Q_EMIT hoverChanged();
    refreshHover();
}

/// At most one query is in flight; of those that wait the newest counts, but a press's is never displaced.
void PointerInput::requestHover(HoverQuery query)
{
    query.view = m_view;
    query.turned = m_stroke.turned();
    if (!m_inFlight) {
        m_inFlight = query;
        sendQuery(query);
    } else if (!m_next || !m_next->forPress || query.forPress) {
        m_next = query;
    }
}

/// What a brush would take is of no use to a press, which shall be answered soon, and in a stroke.
void PointerInput::sendQuery(const HoverQuery& query)
{
    const core::StrokeSettings settings = m_brush->stroke();
    const bool wanted =
        settings.brush == core::BrushShape::Ray && !query.forPress && !m_isGesture && m_drag == Drag::None;
    Q_EMIT hoverRequested(query.ray, wanted ? std::optional(settings) : std::nullopt);
}

void PointerInput::setHover(const std::optional<core::SurfaceHit>& hit,
                            const std::shared_ptr<const core::Footprint>& footprint)
{
    if (!m_inFlight)
        return;
    const HoverQuery answered = *m_inFlight;
    m_inFlight.reset();
    if (answered.view == m_view) {
        m_hit = hit;
        m_footprint = footprint;
        if (m_hit && m_stroke.turned() != answered.turned)
            m_hit = turnedBack(*m_hit, m_stroke.turned() - answered.turned);
        m_answeredPixel = answered.pixel;
    }
    if (m_drag == Drag::Stroke && hit)
        m_camera->setPivot(hit->position);
    if (answered.forPress) {
        processPending(hit);
        Q_EMIT pressDecided();
    }
    if (m_next && !m_inFlight) {
        const HoverQuery next = *m_next;
        m_next.reset();
        requestHover(next);
    }
    Q_EMIT hoverChanged();
}

/// The press at the front is decided; what came after it follows, up to the next press that needs an answer.
void PointerInput::processPending(const std::optional<core::SurfaceHit>& hit)
{
    std::deque<PendingEvent> events;
    events.swap(m_pending);
    begin(events.front(), hit);
    events.pop_front();
    while (!events.empty()) {
        const PendingEvent pending = events.front();
        if (isUndecided(pending.event)) {
            m_pending.swap(events);
            requestHover({pending.event.pixel, pending.ray, true});
            return;
        }
        events.pop_front();
        process(pending);
    }
}

/// A left press for the brush at a place that no answer is about.
bool PointerInput::isUndecided(const PointerEvent& event) const
{
    return event.kind == PointerEvent::Kind::Press && event.button == Qt::LeftButton &&
           viewDrag(event.button, event.modifiers, m_preferences) == Drag::None && m_drag == Drag::None &&
           !m_isAdding && m_answeredPixel != event.pixel;
}

std::optional<core::SurfaceHit> PointerInput::hover() const
{
    if (m_isAdding && m_inside && !movesView())
        return core::SurfaceHit{m_camera->acrossPivot(m_camera->ray(m_last)), -m_camera->viewDirection(), 0,
                                core::noSlot};
    const bool next = m_drag == Drag::None && viewDrag(Qt::LeftButton, m_modifiers, m_preferences) != Drag::None;
    return m_inside && !m_isGesture && !movesView() && !next && !m_isPicking && !m_isPointing ? m_hit : std::nullopt;
}

std::optional<core::SurfaceHit> PointerInput::pointed() const
{
    return m_isPointing && m_inside && !m_isGesture && m_drag == Drag::None ? m_hit : std::nullopt;
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
