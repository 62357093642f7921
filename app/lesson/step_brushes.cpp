#include "app/lesson/step_brushes.h"

#include <algorithm>
#include <utility>

namespace app
{
StepBrushes::StepBrushes(ui::BrushSettings* brush) : m_brush(brush)
{
    connect(brush, &ui::BrushSettings::changed, this, &StepBrushes::follow);
}

void StepBrushes::take(const core::LessonStep& step)
{
    m_tool.reset();
    m_brushes = core::brushesOf(step);
    if (!m_before)
        m_before = Before{m_brush->tool(), m_brush->radiusShare(), m_brush->offeredTools(), {}};
    for (const core::LessonBrush& brush : m_brushes)
        m_before->values.try_emplace(brush.tool, m_brush->tools()->of(brush.tool));
    m_brush->offerTools(step.tools.empty() ? m_before->offered
                                           : QList<core::Tool>(step.tools.begin(), step.tools.end()));
    if (!m_brushes.empty() && m_brush->isOffered(m_brushes.front().tool))
        m_brush->setTool(m_brushes.front().tool);
    m_tool = m_brush->tool();
    setValues();
}

/// Sets radius and strength only when the tool changes, so that the pupil may then change them.
void StepBrushes::follow()
{
    if (m_tool && std::exchange(m_tool, m_brush->tool()) != m_brush->tool())
        setValues();
}

void StepBrushes::setValues()
{
    const auto found = std::ranges::find(m_brushes, m_brush->tool(), &core::LessonBrush::tool);
    if (found == m_brushes.end())
        return;
    m_brush->setValue(core::Parameter::Radius, found->radius);
    m_brush->setValue(core::Parameter::Strength, found->strength);
}

void StepBrushes::giveBack()
{
    m_tool.reset();
    m_brushes.clear();
    const std::optional<Before> before = std::exchange(m_before, std::nullopt);
    if (!before)
        return;
    m_brush->offerTools(before->offered);
    for (const auto& [tool, own] : before->values) {
        ui::ToolValues values = m_brush->tools()->of(tool);
        values.strength = own.strength;
        values.radiusShare = own.radiusShare;
        m_brush->tools()->set(tool, values);
    }
    m_brush->setTool(before->tool);
    m_brush->setRadiusShare(before->radiusShare);
}
} // namespace app
