#pragma once

#include "core/lesson/lesson.h"
#include "ui/settings/brush_settings.h"

#include <map>

namespace app
{
/// Puts the teacher's brush into the pupil's hand: each tool of a step comes with the radius and strength of the
/// teacher's first stroke with it. Thread: gui.
class StepBrushes : public QObject
{
    Q_OBJECT

public:
    /// Not owned; must outlive this.
    explicit StepBrushes(ui::BrushSettings* brush);

    /// Offers the step's tools, with the first of them in the hand; of a step that names none, those that were offered
    /// before the first take().
    void take(const core::LessonStep& step);
    /// Offers the tools, and gives them back what they had, as before the first take().
    void giveBack();

private:
    void follow();
    void setValues();

    ui::BrushSettings* m_brush;
    std::vector<core::LessonBrush> m_brushes; ///< of the step
    std::optional<core::Tool> m_tool;         ///< in the hand; none: no step
    std::map<core::Tool, ui::ToolValues> m_before;
    std::optional<QList<core::Tool>> m_offeredBefore; ///< none: nothing was taken
};
} // namespace app
