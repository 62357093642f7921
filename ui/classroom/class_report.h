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
/// What was found of one model's file.
struct ReportRow
{
    std::filesystem::path file;
    QString problem;                        ///< one sentence: it cannot be read
    std::optional<core::MeshReport> report; ///< none: see problem
    QImage picture;                         ///< square, transparent around the model; null: none was made
    std::optional<core::WorkDone> work;     ///< none: the file does not say
    QString name = {};                      ///< empty: the file's
    QString answersProblem = {};            ///< one sentence, if not all answers beside the file can be read
    QString lesson = {};                    ///< how far the pupil has come in one; empty: there was none
    std::optional<double> turnSeconds = {}; ///< a pupil's turn took; none: it is no work of a class

    /// Seconds that the turn took or, of other files, the strokes.
    std::optional<double> seconds() const;
};

/// A folder of models for whoever has to judge them all: a row each, in the order in which they are to stand.
struct ClassReport
{
    QString folder; ///< for the title
    QDate date;
    QList<ReportRow> rows;
    QList<Questionnaire> questionnaires = {}; ///< one a pupil's turn, none empty; none: nobody was asked
};

enum class ReportVerdict { Ready, NotReady, Unreadable };

/// A row in the person's language. What is not known is empty.
struct ReportCells
{
    QString name, size, volume;
    ReportVerdict verdict;
    QString word; ///< the verdict
    QString note; ///< why not, or what to look at; may be empty
    QString time, strokes;
    QString lesson; ///< how far the pupil has come in one
};

/// Any thread.
ReportCells cellsOf(const ReportRow& row);
/// The heads over the cells: name, size, volume, verdict, time, strokes.
QStringList reportHeads();
/// A question and the sum of its answers, in the person's language.
struct QuestionCells
{
    QString question;
    QString scale; ///< the meaning of its ends
    QString answers, mean;
    std::array<QString, maxAnswer> counts; ///< of each point; empty instead of 0
};

/// Returns the rows in the order of Question; none if nobody answered.
QList<QuestionCells> questionCellsOf(const ClassReport& report);
/// Returns the heads over these: question, answers, mean and the points.
QStringList questionHeads();
QString questionsTitle();
QString reportTitle(const ClassReport& report);
/// One line with counts.
QString reportSummary(const ClassReport& report);

/// From the report's file to a model's, for people to click: relative, with / between folders, each byte of a name that
/// means something in a URL as %XX. Asks the disk about links among the folders.
QString reportLink(const std::filesystem::path& report, const std::filesystem::path& model);

/// In the format that the file's ending says, one of reportEndings() (ui/util/format_filters.h): the page of a browser,
/// alone in its file, or A4 for a printer. Does not commit. Throws core::FileError. Any thread; a few ms a row.
void writeReport(core::AtomicFile& file, const ClassReport& report);
} // namespace ui
