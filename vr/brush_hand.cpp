#include "brush_hand.h"

namespace vr
{
namespace
{
/// What people choose by hand or panel, and both windows show.
bool isSameChoice(const core::StrokeSettings& a, const core::StrokeSettings& b)
{
    return a.tool == b.tool && a.brush == b.brush && a.topology == b.topology && a.symmetry == b.symmetry &&
           a.color == b.color;
}
} // namespace

void BrushHand::take(const DocumentNews& news)
{
    m_state.plane = news.plane;
    if (news.brushChange == m_seenChange)
        return;
    m_seenChange = news.brushChange;
    m_state.stroke = news.brush;
}

void BrushHand::change(const BrushState& state)
{
    const bool isNews = !isSameChoice(state.stroke, m_state.stroke);
    m_state = state;
    if (isNews)
        m_port->wish(ChooseBrush{state.stroke});
}

bool BrushHand::begin(const BeginStroke& begin, const Room& room)
{
    m_draws = m_port->beginStroke(strokeSettings(m_state, begin, room));
    return m_draws;
}

void BrushHand::draw(const StrokePoint& point, const Room& room)
{
    if (!m_draws)
        return;
    m_pressure = point.pressure;
    m_port->addSample(strokeSample(m_state, point, room));
}

void BrushHand::end()
{
    if (m_draws)
        m_port->endStroke();
    m_draws = false;
    m_pressure = 0;
}

/// A ray's footprint is not asked for within a stroke: what it would take is being taken.
void BrushHand::look(const std::optional<Pose>& tip, const Room& room)
{
    m_tip = tip;
    if (std::optional<SurfaceAnswer> answer = m_port->takeAnswer())
        m_answer = *std::move(answer);
    if (!tip)
        m_answer = {};
    else
        m_port->ask({{room.toModel(tip->position), room.directionToModel(tip->forward())}, settings(room), !m_draws});
}

bool BrushHand::touches() const
{
    return m_answer.hit && (!isRay() || m_draws);
}

std::optional<double> BrushHand::reach(const Room& room) const
{
    return isRay() && m_answer.hit ? std::optional(room.lengthToRoom(m_answer.hit->distance)) : std::nullopt;
}

std::variant<std::monostate, BallBrush, RayBrush> BrushHand::shown(const Room& room) const
{
    if (!m_tip)
        return {};
    if (!isRay())
        return BallBrush{m_tip->position, m_state.radius, m_state.stroke.falloff};
    RayBrush ray{{m_tip->position, m_tip->forward()}, {}};
    if (m_answer.hit)
        ray.hit = RayBrush::Hit{room.toRoom(m_answer.hit->position), room.directionToRoom(m_answer.hit->normal),
                                m_state.radius};
    return ray;
}
} // namespace vr
