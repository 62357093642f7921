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
/// Draws the picture of a step: from the step's view, if it has one.
QImage lessonPicture(const core::TriangleMesh& mesh, const std::optional<core::LessonView>& from);

/// A lesson that was played to its end.
struct CheckedLesson
{
    /// As it is to be written, with its pictures; null: it cannot be written, or the check was cancelled.
    std::shared_ptr<const core::Lesson> lesson;
    QString problem;     ///< why not: one sentence; empty if it was cancelled
    QStringList remarks; ///< what is not as it should be, step by step
};

/// A teacher's lesson to its file, in words for people. Any thread. Never throws.
class LessonSaving
{
    Q_DECLARE_TR_FUNCTIONS(app::LessonSaving)

public:
    /// What it lacks, one sentence; empty: it can be checked.
    static QString missing(const core::LessonDraft& draft);
    /// By the strict reader, on the very bytes that are to be written, and played. `hash`: of the model that its
    /// strokes are to leave; nothing: any.
    static CheckedLesson check(const core::LessonDraft& draft, const std::filesystem::path& path,
                               const std::optional<std::uint64_t>& hash, const core::JobControl& control);
    /// Empty, or what is wrong; then nothing has changed on disk.
    static QString write(const core::Lesson& lesson, const std::filesystem::path& path);

    /// Of a stroke or command.
    static QString nameOf(const core::FileEntry& entry);
    /// Its tool and radius.
    static QString lineOf(const core::Stroke& stroke);

private:
    static QStringList remarksOn(const core::LessonStep& step, std::size_t index, const core::StepCheck& check);
};
} // namespace app
