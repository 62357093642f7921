#include "app/lesson/lesson_library.h"

#include "app/model/model_loader.h"

#include <QFile>
#include <QFileInfo>

namespace app
{
namespace
{
core::LessonFiles bundledFiles(const QString& name)
{
    const QString folder = QStringLiteral(":/lessons/%1/").arg(name);
    return {toPath(name), [folder](const std::string& file, std::size_t maxBytes) -> std::optional<std::string> {
                QFile resource(folder + QString::fromStdString(file));
                if (!resource.open(QIODevice::ReadOnly))
                    return std::nullopt;
                return resource.read(static_cast<qint64>(maxBytes) + 1).toStdString();
            }};
}
} // namespace

QStringList bundledLessons()
{
    return {QStringLiteral("first-clay"), QStringLiteral("mug"), QStringLiteral("creature"), QStringLiteral("toy-car")};
}

core::Lesson readLesson(const QString& pathOrName)
{
    if (!QFileInfo::exists(pathOrName) && bundledLessons().contains(pathOrName))
        return core::readLesson(bundledFiles(pathOrName));
    return core::readLesson(toPath(pathOrName));
}

core::Lesson readLessonOfClass(const QString& pathOrName)
{
    if (bundledLessons().contains(pathOrName))
        return core::readLesson(bundledFiles(pathOrName));
    return core::readLesson(toPath(pathOrName));
}
} // namespace app
