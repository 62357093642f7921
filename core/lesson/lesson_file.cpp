#include "core/lesson/lesson_file.h"

#include "core/io/mesh_io.h"
#include "core/lesson/lesson_json_reader.h"

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
    std::error_code problem;
    const std::filesystem::file_status status = std::filesystem::status(path, problem);
    switch (status.type()) {
    case std::filesystem::file_type::directory:
        return readLesson(lessonFolder(path));
    case std::filesystem::file_type::regular:
        return readLesson(lessonZip(path));
    case std::filesystem::file_type::not_found:
        throw FileError(FileErrorKind::NotFound, path);
    default:
        break;
    }
    throw FileError(problem ? FileErrorKind::NotReadable : FileErrorKind::NotAFile, path, problem.value());
}

TriangleMesh modelIn(const Lesson& lesson, const std::string& file)
{
    return parseMesh(file, lesson.files.at(file));
}
} // namespace core
