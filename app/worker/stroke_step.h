#pragma once

#include "core/journal/journal_record.h"

#include <QCoreApplication>
#include <QString>

#include <memory>
#include <optional>

namespace app
{
struct StrokeReport;

/// What History shows of a step besides its name, and what did it.
struct StepMarks
{
    QString icon;     ///< of those in resources/icons
    quint64 dabs = 0; ///< 0: it was no stroke
    quint64 fusions = 0;
    std::shared_ptr<const core::FileEntry> recordedStep; ///< null: not known
};

struct StepDescription
{
    QString text;
    StepMarks marks;
};

/// Names and icons of finished strokes, and their form in the journal.
class StrokeStep
{
    Q_DECLARE_TR_FUNCTIONS(app::StrokeStep)

public:
    static QString textOf(core::Tool tool);
    static QString iconOf(core::Tool tool);
    /// Of the brush's model, or of a ball.
    static QString textOfAdding(bool isModel);
    /// Any thread.
    static StepDescription descriptionOf(const StrokeReport& report);
    /// What descriptionOf() was made of; nothing if it was no stroke, or cannot be done again without its files.
    static std::optional<StrokeReport> reportOf(const StepMarks& marks);
    static core::JournalStep forJournal(const QString& text, const StepMarks& marks);
    static StepDescription fromJournal(const core::JournalStep& step);
};
} // namespace app
