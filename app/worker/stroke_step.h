#pragma once

#include "core/journal/journal_record.h"

#include <QCoreApplication>
#include <QString>

#include <memory>
#include <optional>

namespace app
{
struct StrokeReport;

/// Details of an undo step that the History panel shows besides its name, and the recorded step.
struct StepMarks
{
    QString icon;     ///< name of an icon in resources/icons
    quint64 dabs = 0; ///< number of dabs; 0: the step is not a stroke
    quint64 fusions = 0;
    std::shared_ptr<const core::FileEntry> recordedStep; ///< the stroke or command that made the step; null: unknown
};

struct StepDescription
{
    QString text;
    StepMarks marks;
};

/// Names and icons of finished strokes, and their conversion to and from the journal's form.
class StrokeStep
{
    Q_DECLARE_TR_FUNCTIONS(app::StrokeStep)

public:
    static QString textOf(core::Tool tool);
    static QString iconOf(core::Tool tool);
    /// Returns the name of a step that adds the brush's model (`isModel`) or a ball.
    static QString textOfAdding(bool isModel);
    /// Returns the name of a step that changes one of several parts: with the name of the part. Thread: any.
    static QString textOfPart(const std::optional<core::Part>& part, const QString& text);
    /// Returns the name and details of a reported stroke. Thread: any.
    static StepDescription descriptionOf(const StrokeReport& report);
    /// Returns a report that gives the same description and recorded step, without delta and facts. Returns nothing if
    /// the step is not a stroke, or if repeating it needs an alpha or model file.
    static std::optional<StrokeReport> reportOf(const StepMarks& marks);
    static core::JournalStep forJournal(const QString& text, const StepMarks& marks);
    static StepDescription fromJournal(const core::JournalStep& step);
};
} // namespace app
