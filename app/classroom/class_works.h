#pragma once

#include "app/classroom/lesson_result.h"

#include <QDateTime>
#include <QList>
#include <QString>

#include <filesystem>
#include <optional>

namespace app
{
/// Facts about a turn from the turn.json of its work. Missing values are empty or invalid.
struct TurnFacts
{
    QString id, pupil;
    QDateTime begun, ended;
    std::optional<LessonResult> lesson; ///< nothing: the turn had no lesson
    std::optional<double> used;         ///< time used, seconds, without pauses; nothing: unknown

    /// Returns the used seconds or, if these are unknown, the seconds from beginning to end; nothing: unknown.
    std::optional<double> seconds() const;
};

/// A model to be checked: a file, or a pupil's work.
struct FoundModel
{
    std::filesystem::path file;
    QString work = {};     ///< folder of the work; empty: the model is not a work
    TurnFacts turn = {};   ///< facts about the turn of a work
    QString pupil = {};    ///< display name of the work; includes the turn's beginning if several turns have this pupil
    QString title() const; ///< returns the display name of the work, or the file's name
};

/// Returns the models of a folder, sorted by name. Works of a class in the folder come first, sorted by pupil. Of the
/// several works of a resumed turn only the last is returned. `folder` may also be a single work. Throws
/// core::FileError if there is no model. Thread: any.
QList<FoundModel> modelsAndWorks(const std::filesystem::path& folder);
} // namespace app
