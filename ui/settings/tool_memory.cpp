#include "ui/settings/tool_memory.h"

#include <utility>

namespace ui
{
void putInto(core::StrokeSettings& stroke, const ToolValues& values)
{
    stroke.strength = values.strength;
    stroke.falloff = values.falloff;
    stroke.spacing = values.spacing;
    stroke.alpha = values.alpha;
    stroke.alphaFollows = values.alphaFollows;
    stroke.anchored = values.anchored;
}

void takeFrom(const core::StrokeSettings& stroke, ToolValues& values)
{
    values.strength = stroke.strength;
    values.falloff = stroke.falloff;
    values.spacing = stroke.spacing;
    values.alpha = stroke.alpha;
    values.alphaFollows = stroke.alphaFollows;
    values.anchored = stroke.anchored;
}

void ToolMemory::set(core::Tool tool, const ToolValues& values)
{
    const ToolValues before = std::exchange(m_values[static_cast<std::size_t>(tool)], values);
    if (before == values)
        return;
    Q_EMIT changed(tool);
    if (before.airbrush != values.airbrush)
        Q_EMIT airbrushChanged();
}

void ToolMemory::reset()
{
    for (std::size_t i = 0; i < m_values.size(); ++i)
        set(static_cast<core::Tool>(i), {});
    setSharesRadius(true);
}

void ToolMemory::setAirbrush(core::Tool tool, bool on)
{
    if (isAirbrush(tool) == on || !core::canAirbrush(tool))
        return;
    ToolValues values = of(tool);
    values.airbrush = on ? core::defaultAirbrush : 0;
    set(tool, values);
}

void ToolMemory::setSharesRadius(bool shares)
{
    if (std::exchange(m_sharesRadius, shares) != shares)
        Q_EMIT sharesRadiusChanged(shares);
}
} // namespace ui
