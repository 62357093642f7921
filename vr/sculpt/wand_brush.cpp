#include "vr/sculpt/wand_brush.h"

#include <algorithm>
#include <utility>

namespace vr
{
namespace
{
/// What people choose by hand or panel, and both windows show.
bool isSameChoice(const core::StrokeSettings& a, const core::StrokeSettings& b)
{
    return a.tool == b.tool && a.brush == b.brush && a.topology == b.topology && a.symmetry == b.symmetry &&
           a.radial == b.radial && a.color == b.color;
}
} // namespace

void BrushHand::take(const DocumentNews& news, const Room& room)
{
    m_state.plane = news.plane;
    m_smooths = news.smooths;
    if (std::exchange(m_seenRadius, news.radiusChange) != news.radiusChange)
        m_state.radius = std::clamp(room.lengthToRoom(news.brush.radius), leastRadius, mostRadius);
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

bool BrushHand::begin(BeginStroke begin, const Room& room)
{
    begin.smooths = begin.smooths && m_smooths;
    m_draws = m_port->beginStroke(strokeSettings(m_state, begin, room));
    return m_draws;
}

void BrushHand::draw(const StrokePoint& point, const Room& room)
{
    if (!m_draws)
        return;
    m_pressure = point.pressure;
    core::StrokeSample sample = strokeSample(m_state, point, room);
    if (!m_firstTime)
        m_firstTime = point.time;
    sample.time -= *m_firstTime;
    m_port->addSample(sample);
}

void BrushHand::end()
{
    if (m_draws)
        m_port->endStroke();
    m_draws = false;
    m_pressure = 0;
}

/// A ray's footprint is not asked for within a stroke: what it would take is being taken.
void BrushHand::look(const Room& room)
{
    if (std::optional<SurfaceAnswer> answer = m_port->takeAnswer())
        m_answer = *std::move(answer);
    if (!m_tip)
        m_answer = {};
    else
        m_port->ask(
            {{room.toModel(m_tip->position), room.directionToModel(m_tip->forward())}, settings(room), !m_draws});
}

/// A stroke may be ahead of what is answered.
bool BrushHand::touches(const Room& room) const
{
    if (!m_answer.hit || !m_tip)
        return false;
    const double distance = (room.toRoom(m_answer.hit->position) - m_tip->position).norm();
    return m_draws || (!isRay() && distance <= m_state.radius);
}

std::optional<double> BrushHand::reach(const Room& room) const
{
    if (!isRay() || !m_answer.hit || !m_tip)
        return std::nullopt;
    const core::Vec3 way = room.toRoom(m_answer.hit->position) - m_tip->position;
    const double along = way.dot(m_tip->forward());
    const bool isOnRay = (way - along * m_tip->forward()).norm() <= m_state.radius;
    return along > 0 && isOnRay ? std::optional(along) : std::nullopt;
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
