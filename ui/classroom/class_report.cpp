// Texts of the report's rows, shared by report_html and report_pdf, which lay them out.

#include "ui/classroom/class_report.h"

#include "ui/classroom/report_html.h"
#include "ui/classroom/report_pdf.h"
#include "ui/util/error_messages.h"
#include "ui/util/number_format.h"
#include "ui/util/path_display.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
namespace fs = std::filesystem;

struct ReportText
{
    Q_DECLARE_TR_FUNCTIONS(ui::ClassReport)
};

ReportVerdict verdictOf(const ReportRow& row)
{
    if (!row.report)
        return ReportVerdict::Unreadable;
    return row.report->printReady() ? ReportVerdict::Ready : ReportVerdict::NotReady;
}

QString verdictText(ReportVerdict verdict)
{
    const QString texts[] = {ReportText::tr("Print-ready"), ReportText::tr("Not print-ready"),
                             ReportText::tr("Cannot be read")};
    static_assert(std::size(texts) == static_cast<std::size_t>(ReportVerdict::Unreadable) + 1);
    return texts[static_cast<std::size_t>(verdict)];
}

QString remarkOf(const ReportRow& row)
{
    QStringList remarks;
    if (!row.report)
        remarks << row.problem;
    else if (!row.report->printReady())
        remarks << ErrorMessages::faults(*row.report);
    else if (row.report->volume)
        remarks << ErrorMessages::unitDoubt(*row.report->volume);
    remarks << row.answersProblem;
    remarks.removeAll(QString());
    return remarks.join(QStringLiteral(" · "));
}

/// Replaces unprintable characters such as line breaks by spaces; file names may contain any.
QString plain(QString text)
{
    for (QChar& c : text)
        c = c.isPrint() || c.isSurrogate() ? c : QLatin1Char(' ');
    return text;
}

struct ReportFormat
{
    QLatin1StringView ending;
    QByteArray (*write)(const ClassReport& report, const fs::path& path);
};
constexpr ReportFormat reportFormats[] = {{QLatin1StringView("html"), reportHtml},
                                          {QLatin1StringView("pdf"), reportPdf}};

/// Returns the absolute folder of a file with symbolic links resolved, so that ".." in a relative link is correct. If
/// the disk cannot be read, links stay unresolved.
fs::path folderOf(const fs::path& file)
{
    std::error_code problem;
    const fs::path whole = fs::absolute(file, problem).parent_path();
    const fs::path real = fs::weakly_canonical(whole, problem);
    return problem ? whole.lexically_normal() : real;
}
} // namespace

std::optional<double> ReportRow::seconds() const
{
    if (turnSeconds || !work)
        return turnSeconds;
    return work->seconds;
}

ReportCells cellsOf(const ReportRow& row)
{
    ReportCells cells{plain(row.name.isEmpty() ? displayName(row.file.filename()) : row.name),
                      {},
                      {},
                      verdictOf(row),
                      verdictText(verdictOf(row)),
                      plain(remarkOf(row)),
                      {},
                      {},
                      plain(row.lesson)};
    if (row.report) {
        const core::Vec3& size = row.report->size;
        cells.size =
            QStringLiteral("%1 × %2 × %3").arg(millimetres(size.x()), millimetres(size.y()), millimetres(size.z()));
        cells.volume = row.report->volume ? volumeText(std::abs(*row.report->volume)) : QString();
    }
    if (const auto seconds = row.seconds())
        cells.time = durationText(*seconds);
    if (row.work)
        cells.strokes = number(row.work->strokes);
    return cells;
}

QStringList reportHeads()
{
    return {ReportText::tr("Model"),       ReportText::tr("Size, mm"), ReportText::tr("Volume"),
            ReportText::tr("Print-ready"), ReportText::tr("Time"),     ReportText::tr("Strokes")};
}

QList<QuestionCells> questionCellsOf(const ClassReport& report)
{
    QList<QuestionCells> cells;
    if (report.questionnaires.isEmpty())
        return cells;
    const auto sums = sumsOf(report.questionnaires);
    for (std::size_t i = 0; i < questionCount; ++i) {
        const QuestionWords words = QuestionWords::of(static_cast<Question>(i));
        const AnswerSum& sum = sums[i];
        QuestionCells row{words.question,
                          QStringLiteral("%1 = %2 · %3 = %4")
                              .arg(QString::number(minAnswer), words.low, QString::number(maxAnswer), words.high),
                          number(static_cast<std::uint64_t>(sum.total())),
                          sum.total() == 0 ? QString() : QLocale().toString(sum.mean(), 'f', 2),
                          {}};
        for (std::size_t point = 0; point < row.counts.size(); ++point)
            if (sum.counts[point] > 0)
                row.counts[point] = number(static_cast<std::uint64_t>(sum.counts[point]));
        cells << row;
    }
    return cells;
}

QStringList questionHeads()
{
    QStringList heads{ReportText::tr("Question"), ReportText::tr("Answers"), ReportText::tr("Mean")};
    for (int point = minAnswer; point <= maxAnswer; ++point)
        heads << QString::number(point);
    return heads;
}

QString questionsTitle()
{
    return ReportText::tr("What the pupils answered");
}

QString reportTitle(const ClassReport& report)
{
    return ReportText::tr("Class report: %1").arg(plain(report.folder));
}

QString reportSummary(const ClassReport& report)
{
    const auto count = [&report](ReportVerdict verdict) {
        return number(static_cast<std::uint64_t>(std::ranges::count(report.rows, verdict, verdictOf)));
    };
    return ReportText::tr("%1 · models: %2 · print-ready: %3 · not print-ready: %4 · cannot be read: %5")
        .arg(QLocale().toString(report.date, QLocale::LongFormat),
             number(static_cast<std::uint64_t>(report.rows.size())), count(ReportVerdict::Ready),
             count(ReportVerdict::NotReady), count(ReportVerdict::Unreadable));
}

QString reportLink(const fs::path& report, const fs::path& model)
{
    const fs::path way = (folderOf(model) / model.filename()).lexically_relative(folderOf(report));
    const std::u8string bytes = way.generic_u8string();
    return QString::fromLatin1(
        QByteArray(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()))
            .toPercentEncoding("/"));
}

void writeReport(core::AtomicFile& file, const ClassReport& report)
{
    const QString ending = displayName(file.path().extension()).mid(1).toLower();
    const auto format = std::ranges::find(reportFormats, ending, &ReportFormat::ending);
    Q_ASSERT(format != std::end(reportFormats));
    const QByteArray bytes = format->write(report, file.path());
    file.write({bytes.constData(), static_cast<std::size_t>(bytes.size())});
}
} // namespace ui
