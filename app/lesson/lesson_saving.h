#pragma once

#include "core/lesson/lesson_draft.h"
#include "core/util/job_control.h"

#include <QCoreApplication>
#include <QImage>
#include <QStringList>

#include <filesystem>
#include <memory>
#include <optional>

namespace core
{
struct StepCheck;
}

namespace app
{
/// Returns the picture of a step, drawn from the step's view if it has one.
QImage lessonPicture(const core::TriangleMesh& mesh, const std::optional<core::LessonView>& from);

/// A lesson that was checked by playing it to its end.
struct CheckedLesson
{
    /// the lesson to write, with its pictures; null: it cannot be written, or the check was cancelled
    std::shared_ptr<const core::Lesson> lesson;
    QString problem;     ///< one sentence why the lesson cannot be written; empty if it can or the check was cancelled
    QStringList remarks; ///< defects of the lesson that do not prevent writing, step by step
};

/// Checks and writes a teacher's lesson, with messages for the user. Thread: any. Never throws.
class LessonSaving
{
    Q_DECLARE_TR_FUNCTIONS(app::LessonSaving)

public:
    /// Returns one sentence about a missing part; empty if the draft is complete and can be checked.
    static QString missing(const core::LessonDraft& draft);
    /// Checks the draft: reads the bytes to be written with the strict reader, and plays the lesson. `hash`: expected
    /// hash of the final model; nullopt: not compared.
    static CheckedLesson check(const core::LessonDraft& draft, const std::filesystem::path& path,
                               const std::optional<std::uint64_t>& hash, const core::JobControl& control);
    /// Returns an empty string, or one sentence about the error; nothing has then changed on disk.
    static QString write(const core::Lesson& lesson, const std::filesystem::path& path);

    /// Returns the translated name of a stroke or command.
    static QString nameOf(const core::FileEntry& entry);
    /// Returns the stroke's tool and radius as text.
    static QString lineOf(const core::Stroke& stroke);

private:
    static QStringList remarksOn(const core::LessonStep& step, std::size_t index, const core::StepCheck& check);
};
} // namespace app
