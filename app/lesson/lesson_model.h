#pragma once

#include "app/lesson/lesson_library.h"
#include "app/model/model_loader.h"

#include "core/lesson/lesson_file.h"

namespace app
{
/// Makes a lesson's model for the window, bit for bit as core::LessonPlayback does: the result of its first `steps`
/// steps; if `steps` is 0, the model with which the lesson begins.
struct LessonModel
{
    std::shared_ptr<const core::Lesson> lesson;
    std::filesystem::path path; ///< path of the lesson, for error messages
    std::size_t steps = 0;
    QString name = {}; ///< name of the model; empty: the lesson's title

    LoadedModel load(const core::JobControl& control) const;
};

/// Returns the content of the start file of a lesson that begins with this model. The file must be called lessonStart.
/// Throws FileError.
std::string lessonStartOf(const core::TriangleMesh& mesh);
inline constexpr char lessonStart[] = "start.glb";

QString inOurLanguage(const core::LessonText& text);
/// Returns the lesson's title without characters that file names cannot have; may be empty.
QString fileNameOf(const core::Lesson& lesson);
/// Returns the lesson's folder if `path` is a lesson.json, otherwise `path`.
QString lessonOrItsFolder(const QString& path);

/// A lesson, or one sentence why it cannot be read.
struct ReadLesson
{
    std::shared_ptr<const core::Lesson> lesson;
    QString problem;
};
/// Reads a lesson by calling `read`. A LessonError or FileError is returned as `problem`, not thrown. Thread: any.
ReadLesson tryToReadLesson(const QString& pathOrName, core::Lesson (*read)(const QString& pathOrName) = readLesson);
} // namespace app
