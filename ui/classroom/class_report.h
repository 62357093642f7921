#pragma once

#include "core/analysis/mesh_check.h"
#include "core/io/document_metadata.h"
#include "core/util/atomic_file.h"
#include "ui/classroom/questionnaire.h"

#include <QDate>
#include <QImage>
#include <QList>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <optional>

namespace ui
{
/// Data about the file of one model.
struct ReportRow
{
    std::filesystem::path file;
    QString problem;                        ///< why the file cannot be read, one sentence; empty: readable
    std::optional<core::MeshReport> report; ///< nullopt: see problem
    QImage picture;                         ///< square, transparent around the model; null: no picture
    std::optional<core::WorkDone> work;     ///< nullopt: the file has no such record
    QString name = {};                      ///< shown name; empty: the file name is shown
    QString answersProblem = {};            ///< set if some answers stored beside the file cannot be read, one sentence
    QString lesson = {};                    ///< the pupil's progress in a lesson; empty: no lesson
    std::optional<double> turnSeconds = {}; ///< seconds of the pupil's turn; nullopt: not the work of a class

    /// Returns the duration of the turn, or of the work recorded in the file if there was no turn, seconds. nullopt:
    /// neither is known.
    std::optional<double> seconds() const;
};

/// A report on a folder of models for a teacher or judge. Rows are in display order.
struct ClassReport
{
    QString folder; ///< shown in the title
    QDate date;
    QList<ReportRow> rows;
    QList<Questionnaire> questionnaires = {}; ///< one for each turn with answers; empty: no questions were asked
};

enum class ReportVerdict { Ready, NotReady, Unreadable };

/// The texts of a row in the user's language. Unknown values are empty.
struct ReportCells
{
    QString name, size, volume;
    ReportVerdict verdict;
    QString word; ///< the verdict as text
    QString note; ///< why the model is not ready, or what to check; may be empty
    QString time, strokes;
    QString lesson; ///< the pupil's progress in a lesson
};

/// Returns the texts of a row. Thread: any.
ReportCells cellsOf(const ReportRow& row);
/// Returns the column heads: name, size, volume, verdict, time, strokes.
QStringList reportHeads();
/// A row of the table of questions, in the user's language: a question and the sum of its answers.
struct QuestionCells
{
    QString question;
    QString scale; ///< meaning of the scale's two ends
    QString answers, mean;
    std::array<QString, maxAnswer> counts; ///< number of answers for each point; empty instead of 0
};

/// Returns a row for each question, in the order of Question; empty if nobody answered.
QList<QuestionCells> questionCellsOf(const ClassReport& report);
/// Returns the heads of the table of questions: question, answers, mean and the points.
QStringList questionHeads();
QString questionsTitle();
QString reportTitle(const ClassReport& report);
/// Returns one line with the date and, for each verdict, the number of models.
QString reportSummary(const ClassReport& report);

/// Returns a relative URL from the report's file to a model's file, with / between folders and %XX escapes. Reads the
/// disk to resolve symbolic links.
QString reportLink(const std::filesystem::path& report, const std::filesystem::path& model);

/// Writes the report as HTML or PDF, chosen by the file's suffix (reportEndings() in ui/util/format_filters.h): one
/// self-contained page for a browser, or A4 pages for a printer. Does not commit the file. Throws core::FileError.
/// Thread: any. Cost: a few ms for each row.
void writeReport(core::AtomicFile& file, const ClassReport& report);
} // namespace ui
