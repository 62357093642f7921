#pragma once

#include "app/lesson/lesson_library.h"
#include "app/model/model_loader.h"

#include "core/lesson/lesson_file.h"

namespace app
{
/// A lesson's model for the window, to the bit what core::LessonPlayback has: what its first `steps` steps leave, or
/// its start. Like ModelLoader.
struct LessonModel
{
    std::shared_ptr<const core::Lesson> lesson;
    std::filesystem::path path; ///< of the lesson, for errors
    std::size_t steps = 0;
    QString name = {}; ///< of the model; empty: the lesson's

    LoadedModel load(const core::JobControl& control) const;
};

/// What the file holds that a lesson begins with, if it begins with this model: to be named lessonStart. Throws
/// FileError.
std::string lessonStartOf(const core::TriangleMesh& mesh);
inline constexpr char lessonStart[] = "start.glb";

QString inOurLanguage(const core::LessonText& text);
/// Returns the lesson's title, as files may be called; may be empty.
QString fileNameOf(const core::Lesson& lesson);
/// What is chosen by its lesson.json is the folder.
QString lessonOrItsFolder(const QString& path);

/// A lesson, or why not: one sentence.
struct ReadLesson
{
    std::shared_ptr<const core::Lesson> lesson;
    QString problem;
};
/// Reads a lesson by `read`. Never throws; any thread.
ReadLesson tryToReadLesson(const QString& pathOrName, core::Lesson (*read)(const QString& pathOrName) = readLesson);
} // namespace app
