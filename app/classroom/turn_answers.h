#pragma once

#include "ui/classroom/questionnaire.h"

#include <QCoreApplication>

namespace app
{
/// What a pupil answered after a turn, beside the work: answers.json in its folder. It is a file of its own because the
/// work is kept before the questions are asked, and must not be touched for them. Any thread; never throws.
class TurnAnswers
{
    Q_DECLARE_TR_FUNCTIONS(app::TurnAnswers)

public:
    static const QString fileName;

    QString turnId; ///< of ClassTurn; a turn that was resumed has left several works
    ui::Questionnaire questionnaire;
    QString problem = {}; ///< of reading: one sentence about the first value that was left out, or about the file

    /// Nothing of a folder without the file. Values that are wrong are left out.
    static TurnAnswers read(const QString& folder);
    /// Whole or not at all, down to the disk; without an answer no file is left. Returns an empty text or what is
    /// wrong.
    QString write(const QString& folder) const;
};
} // namespace app
