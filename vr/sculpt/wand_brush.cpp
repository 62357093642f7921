#include "vr/sculpt/wand_brush.h"

#include <algorithm>
#include <utility>

namespace vr
{
namespace
{
/// Returns whether the brushes agree in all settings that the headset can change in the window.
bool isSameChoice(const core::StrokeSettings& a, const core::StrokeSettings& b)
{
    return a.tool == b.tool && a.brush == b.brush && a.topology == b.topology && a.symmetry == b.symmetry &&
           a.radial == b.radial && a.color == b.color;
}

/// Takes over the settings that each tool has of its own and that only the window changes. A tool that is chosen in the
/// headset gets its values this way.
void takeToolValues(const core::StrokeSettings& from, core::StrokeSettings& stroke)
{
    stroke.strength = from.strength;
    stroke.falloff = from.falloff;
    stroke.alpha = from.alpha;
    stroke.alphaFollows = from.alphaFollows;
    stroke.anchored = from.anchored;
}
} // namespace

WandBrush::WandBrush(DocumentPort* port, ButtonPreset preset) : m_port(port)
{
    m_state.preset = preset;
    m_state.topology = firstTopology(preset);
}

void WandBrush::take(const DocumentUpdate& update, const ModelPlacement& placement)
{
    m_state.plane = update.plane;
    m_state.airbrush = update.airbrush;
    m_state.smoothStrength = update.smoothStrength;
    m_smooths = update.smooths;
    if (std::exchange(m_seenRadius, update.radiusChange) != update.radiusChange)
        m_state.radius = std::clamp(placement.lengthToRoom(update.brush.radius), minRadius, maxRadius);
    if (update.brush.tool == m_state.stroke.tool)
        takeToolValues(update.brush, m_state.stroke);
    if (update.brushChange == m_seenChange)
        return;
    m_seenChange = update.brushChange;
    m_state.stroke = update.brush;
    if (update.brush.topology != core::Topology::Uniform)
        m_state.stroke.topology = m_state.topology;
}

void WandBrush::change(const BrushState& state)
{
    const bool isChanged = !isSameChoice(state.stroke, m_state.stroke);
    m_state = state;
    if (isChanged)
        m_port->request(ChooseBrush{state.stroke});
}

bool WandBrush::begin(BeginStroke begin, const ModelPlacement& placement)
{
    begin.smooths = begin.smooths && m_smooths;
    m_isDrawing = m_port->beginStroke(strokeSettings(m_state, begin, placement));
    if (m_isDrawing && !begin.smooths && !begin.continues)
        m_state.addsNext = false;
    return m_isDrawing;
}

void WandBrush::draw(const StrokePoint& point, const ModelPlacement& placement)
{
    if (!m_isDrawing)
        return;
    m_pressure = point.pressure;
    core::StrokeSample sample = strokeSample(m_state, point, placement);
    if (!m_firstTime)
        m_firstTime = point.time;
    sample.time -= *m_firstTime;
    m_port->addSample(sample);
}

void WandBrush::end()
{
    if (m_isDrawing)
        m_port->endStroke();
    m_isDrawing = false;
    m_pressure = 0;
}

/// Queries the surface. During a stroke the footprint of a ray brush is not requested, because the stroke is changing
/// that part already.
void WandBrush::querySurface(const ModelPlacement& placement)
{
    if (std::optional<SurfaceQueryResult> result = m_port->takeQueryResult())
        m_queryResult = *std::move(result);
    if (!m_tip)
        m_queryResult = {};
    else
        m_port->querySurface({{placement.toModel(m_tip->position), placement.directionToModel(m_tip->forward())},
                              settings(placement),
                              !m_isDrawing});
}

/// Returns whether the brush meets the surface. During a stroke any hit counts, because the surface may have changed
/// since the answer.
bool WandBrush::touches(const ModelPlacement& placement) const
{
    if (!m_queryResult.hit || !m_tip)
        return false;
    const double distance = (placement.toRoom(m_queryResult.hit->position) - m_tip->position).norm();
    return m_isDrawing || (!isRay() && distance <= m_state.radius);
}

std::optional<double> WandBrush::reach(const ModelPlacement& placement) const
{
    if (!isRay() || !m_queryResult.hit || !m_tip)
        return std::nullopt;
    const core::Vec3 way = placement.toRoom(m_queryResult.hit->position) - m_tip->position;
    const double along = way.dot(m_tip->forward());
    const bool isOnRay = (way - along * m_tip->forward()).norm() <= m_state.radius;
    return along > 0 && isOnRay ? std::optional(along) : std::nullopt;
}

std::variant<std::monostate, BallBrush, RayBrush> WandBrush::shown(const ModelPlacement& placement) const
{
    if (!m_tip)
        return {};
    if (!isRay())
        return BallBrush{m_tip->position, m_state.radius, m_state.stroke.falloff, core::coreShare(m_state.stroke.tool)};
    RayBrush ray{{m_tip->position, m_tip->forward()}, {}};
    if (m_queryResult.hit)
        ray.hit = RayBrush::Hit{placement.toRoom(m_queryResult.hit->position),
                                placement.directionToRoom(m_queryResult.hit->normal), m_state.radius};
    return ray;
}
} // namespace vr
