#pragma once

#include "ui/lesson/lesson_panel.h"

#include <QComboBox>

namespace ui
{
/// A combo box for the lesson of a class: none, a bundled lesson, or a lesson from a file. Thread: gui.
class LessonChoice : public QComboBox
{
    Q_OBJECT

public:
    explicit LessonChoice(const QList<LessonCard>& lessons);

    /// Returns the lesson as stored in Classroom::lesson.
    QString lesson() const { return m_lesson; }
    void setLesson(const QString& lesson);

private:
    void choose(int index);

    QString m_lesson;
};
} // namespace ui
