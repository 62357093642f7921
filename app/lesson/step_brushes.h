#pragma once

#include "core/lesson/lesson.h"
#include "ui/settings/brush_settings.h"

#include <map>
#include <optional>
#include <vector>

namespace app
{
/// Sets the pupil's brush for each lesson step: each tool gets the radius and strength of the teacher's first stroke
/// with that tool. Thread: gui.
class StepBrushes : public QObject
{
    Q_OBJECT

public:
    /// Does not own the brush, which must outlive this.
    explicit StepBrushes(ui::BrushSettings* brush);

    /// Offers the step's tools and selects the tool of the teacher's first stroke. A step without a list of tools
    /// offers the tools that were offered before the first take().
    void take(const core::LessonStep& step);
    /// Restores the offered tools, their settings and the selected tool to their state before the first take().
    void giveBack();

private:
    struct Before
    {
        core::Tool tool;    ///< the selected tool
        double radiusShare; ///< radius of the selected tool (or of all tools), as a share of the model's longest side
        QList<core::Tool> offered;
        std::map<core::Tool, ui::ToolValues> values;
    };

    void follow();
    void setValues();

    ui::BrushSettings* m_brush;
    std::vector<core::LessonBrush> m_brushes; ///< brushes of the present step
    std::optional<core::Tool> m_tool;         ///< the selected tool; none: no step is taken
    std::optional<Before> m_before;           ///< state before the first take(); none: no step is taken
};
} // namespace app
