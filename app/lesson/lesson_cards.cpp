#include "app/lesson/lesson_cards.h"

#include "app/lesson/lesson_library.h"
#include "app/lesson/lesson_model.h"

namespace app
{
QImage pictureOf(const core::Lesson& lesson, const std::string& picture)
{
    const auto found = lesson.files.find(picture);
    return found == lesson.files.end() ? QImage()
                                       : QImage::fromData(reinterpret_cast<const uchar*>(found->second.data()),
                                                          static_cast<int>(found->second.size()));
}

ui::LessonCard cardOf(const QString& name, const core::Lesson& lesson)
{
    return {name, inOurLanguage(lesson.title), inOurLanguage(lesson.summary),
            pictureOf(lesson, lesson.steps.back().picture)};
}

QList<ui::LessonCard> bundledLessonCards()
{
    QList<ui::LessonCard> all;
    for (const QString& name : bundledLessons())
        if (const auto lesson = tryToReadLesson(name).lesson)
            all << cardOf(name, *lesson);
    return all;
}
} // namespace app
