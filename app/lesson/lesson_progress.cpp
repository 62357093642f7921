#include "app/lesson/lesson_progress.h"

#include "app/lesson/lesson_cards.h"
#include "app/lesson/lesson_model.h"

namespace app
{
void LessonProgress::set(std::size_t step, int met, int asked)
{
    m_goals.erase(m_goals.lower_bound(step), m_goals.end());
    if (asked > 0)
        m_goals[step] = {met, asked};
}

ui::LessonPage LessonProgress::endOf(const core::Lesson& lesson, bool canExport) const
{
    Goals all;
    for (const auto& [step, goals] : m_goals) {
        all.met += goals.met;
        all.asked += goals.asked;
    }
    QString text = canExport ? tr("Keep sculpting, export your model, or save the steps as a handout.")
                             : tr("Keep sculpting, if you like.");
    if (all.asked > 0)
        //: %1: how many of them
        text = tr("%1 %2", "two sentences").arg(tr("You met %1 of %n goals.", nullptr, all.asked).arg(all.met), text);
    ui::LessonPage page;
    page.lesson = inOurLanguage(lesson.title);
    page.title = all.met == all.asked ? tr("Well done!") : tr("That was the last step");
    page.text = text;
    page.picture = pictureOf(lesson, lesson.steps.back().picture);
    page.step = page.steps = static_cast<int>(lesson.steps.size());
    return page;
}

QList<ui::LessonMark> LessonProgress::marksOf(const core::Lesson& lesson) const
{
    QList<ui::LessonMark> marks;
    for (const auto& [step, goals] : m_goals)
        marks.append({goals.met == goals.asked, tr("%1: %2 of %3", "step: goals met of goals")
                                                    .arg(inOurLanguage(lesson.steps[step].title))
                                                    .arg(goals.met)
                                                    .arg(goals.asked)});
    return marks;
}
} // namespace app
