#pragma once

#include "ui/classroom/questionnaire.h"

#include <QCoreApplication>

namespace app
{
/// A pupil's answers after a turn, in the file answers.json of the work's folder. They have a file of their own because
/// the work is saved before the questions are asked, and is not written again. Never throws. Thread: any.
class TurnAnswers
{
    Q_DECLARE_TR_FUNCTIONS(app::TurnAnswers)

public:
    static const QString fileName;

    QString turnId; ///< ClassTurn::id; a resumed turn has several works
    ui::Questionnaire questionnaire;
    QString problem = {}; ///< one sentence about the first unreadable value or about the file; empty if there is none

    /// Reads the answers in a folder; empty if there is no file. Invalid values are left out.
    static TurnAnswers read(const QString& folder);
    /// Writes the file completely or not at all, and flushes it to disk. Removes the file if there are no answers.
    /// Returns an empty string, or one sentence about the error.
    QString write(const QString& folder) const;
};
} // namespace app
