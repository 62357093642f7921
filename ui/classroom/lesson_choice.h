#pragma once

#include "ui/lesson/lesson_panel.h"

#include <QComboBox>

namespace ui
{
/// Chooses the lesson of a class: none, one of ours, or one from a file. Thread: gui.
class LessonChoice : public QComboBox
{
    Q_OBJECT

public:
    explicit LessonChoice(const QList<LessonCard>& lessons);

    /// Returns the lesson as Classroom has it.
    QString lesson() const { return m_lesson; }
    void setLesson(const QString& lesson);

private:
    void choose(int index);

    QString m_lesson;
};
} // namespace ui
