#pragma once

#include "ui/classroom/questionnaire.h"

#include <QCoreApplication>

namespace app
{
/// The answers of a pupil after a turn, kept beside the work: answers.json in its folder. This is a file of its own,
/// because the work is kept before the questions are asked and is not written again for them. Never throws. Thread:
/// any.
class TurnAnswers
{
    Q_DECLARE_TR_FUNCTIONS(app::TurnAnswers)

public:
    static const QString fileName;

    QString turnId; ///< of ClassTurn; a turn that was resumed has left several works
    ui::Questionnaire questionnaire;
    QString problem = {}; ///< one sentence about the first value that could not be read, or about the file

    /// Reads the answers in a folder; none if it has no such file. Leaves wrong values out.
    static TurnAnswers read(const QString& folder);
    /// Writes the file whole or not at all, down to the disk; removes it if there is no answer. Returns an empty text,
    /// or a sentence that says what is wrong.
    QString write(const QString& folder) const;
};
} // namespace app
