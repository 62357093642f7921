#pragma once

#include "core/lesson/lesson.h"
#include "ui/lesson/lesson_panel.h"

#include <QCoreApplication>

#include <map>

namespace app
{
/// The goals that a pupil has met in a lesson, and the page that shows them at the end. Thread: gui.
class LessonProgress
{
    Q_DECLARE_TR_FUNCTIONS(app::LessonProgress)

public:
    void clear() { m_goals.clear(); }
    /// Sets the latest result of a step, and forgets later steps.
    void set(std::size_t step, int met, int asked);

    /// Returns the page after the last step. `canExport`: whether the pupil may export files.
    ui::LessonPage endOf(const core::Lesson& lesson, bool canExport) const;
    /// Returns a mark for each step that has goals and was measured.
    QList<ui::LessonMark> marksOf(const core::Lesson& lesson) const;

private:
    struct Goals
    {
        int met = 0, asked = 0;
    };

    std::map<std::size_t, Goals> m_goals; ///< by step index
};
} // namespace app
