#include "core/lesson/lesson_file.h"

#include "core/io/mesh_io.h"
#include "core/lesson/lesson_json_reader.h"
#include "core/util/system_path.h"

namespace core
{
LessonError::LessonError(Kind errorKind, std::filesystem::path lesson)
    : std::runtime_error("lesson: error " + std::to_string(static_cast<int>(errorKind)))
    , kind(errorKind)
    , path(std::move(lesson))
{}

Lesson readLesson(const LessonFiles& files)
{
    return LessonJsonReader(files).read();
}

Lesson readLesson(const std::filesystem::path& path)
{
    const FileStatus status = fileStatus(path);
    switch (status.type) {
    case std::filesystem::file_type::directory:
        return readLesson(lessonFolder(path));
    case std::filesystem::file_type::regular:
        return readLesson(lessonZip(path));
    case std::filesystem::file_type::not_found:
        throw FileError(FileErrorKind::NotFound, path);
    default:
        break;
    }
    throw FileError(status.systemCode != 0 ? FileErrorKind::NotReadable : FileErrorKind::NotAFile, path,
                    status.systemCode);
}

TriangleMesh modelIn(const Lesson& lesson, const std::string& file)
{
    return parseMesh(file, lesson.files.at(file));
}
} // namespace core
