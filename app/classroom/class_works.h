#pragma once

#include "app/classroom/lesson_result.h"

#include <QDateTime>
#include <QList>
#include <QString>

#include <filesystem>
#include <optional>

namespace app
{
/// Facts that turn.json has about the turn that left a work; empty or invalid where it says nothing.
struct TurnFacts
{
    QString id, pupil;
    QDateTime begun, ended;
    std::optional<LessonResult> lesson; ///< none: the turn had none
    std::optional<double> used;         ///< seconds, without pauses

    /// Returns the seconds that it used or, if it does not say, those from its beginning to its end; nothing: unknown.
    std::optional<double> seconds() const;
};

/// A model to be looked at: a file, or a pupil's work.
struct FoundModel
{
    std::filesystem::path file;
    QString work = {};     ///< folder of the turn that left it; empty: it is no work
    TurnFacts turn = {};   ///< of a work
    QString pupil = {};    ///< tells the work from the others: with the turn's beginning where a name comes twice
    QString title() const; ///< pupil, or the file's name
};

/// Returns the models of a folder by name. The works of a class's turns in it come first, by pupil; of a turn that was
/// resumed, which has left several, only the last. The folder of one work is such a folder, too. Throws core::FileError
/// if there is no model. Any thread.
QList<FoundModel> modelsAndWorks(const std::filesystem::path& folder);
} // namespace app
