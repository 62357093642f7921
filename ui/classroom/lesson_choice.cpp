#include "ui/classroom/lesson_choice.h"

#include "ui/widgets/file_dialogs.h"

#include <QDir>
#include <QFileInfo>

namespace ui
{
LessonChoice::LessonChoice(const QList<LessonCard>& lessons)
{
    setObjectName(QStringLiteral("classLesson"));
    setToolTip(tr("Pupils can begin with it: it is shown stroke by stroke, and the report says how far they got."));
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
    addItem(tr("none"), QString());
    for (const LessonCard& card : lessons)
        addItem(card.title, card.name);
    addItem(tr("From a File…"));
    connect(this, &QComboBox::activated, this, &LessonChoice::choose);
}

/// Adds an entry for an unknown lesson, before the last entry, which asks for a file.
void LessonChoice::setLesson(const QString& lesson)
{
    m_lesson = lesson;
    int index = findData(lesson);
    if (index < 0) {
        index = count() - 1;
        insertItem(index, QFileInfo(lesson).fileName(), lesson);
        setItemData(index, QDir::toNativeSeparators(lesson), Qt::ToolTipRole);
    }
    setCurrentIndex(index);
}

/// Chooses an entry. The last entry asks for a file; meanwhile the box shows the previous lesson.
void LessonChoice::choose(int index)
{
    if (index < count() - 1) {
        m_lesson = itemData(index).toString();
        return;
    }
    setLesson(m_lesson);
    askForLesson(this, [this](const QString& path) {
        const QFileInfo file(path);
        setLesson(file.fileName() == QLatin1String("lesson.json") ? file.absolutePath() : path);
    });
}
} // namespace ui
