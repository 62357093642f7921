#pragma once

#include "core/lesson/lesson.h"
#include "ui/settings/brush_settings.h"

#include <map>
#include <optional>
#include <vector>

namespace app
{
/// Puts the teacher's brush into the pupil's hand: each tool of a step comes with the radius and strength of the
/// teacher's first stroke with it. Thread: gui.
class StepBrushes : public QObject
{
    Q_OBJECT

public:
    /// Takes no ownership; the brush must outlive this.
    explicit StepBrushes(ui::BrushSettings* brush);

    /// Offers the step's tools, with that of the teacher's first stroke in the hand; of a step that names none, those
    /// that were offered before the first take().
    void take(const core::LessonStep& step);
    /// Offers the tools, and gives them and the hand back what they had, as before the first take().
    void giveBack();

private:
    struct Before
    {
        core::Tool tool;    ///< in the hand
        double radiusShare; ///< of that tool, or of all
        QList<core::Tool> offered;
        std::map<core::Tool, ui::ToolValues> values;
    };

    void follow();
    void setValues();

    ui::BrushSettings* m_brush;
    std::vector<core::LessonBrush> m_brushes; ///< of the step
    std::optional<core::Tool> m_tool;         ///< in the hand; none: no step
    std::optional<Before> m_before;           ///< none: no step
};
} // namespace app
