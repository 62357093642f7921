// report: writes a page with pictures and checks of the models in a folder.
#include "app/classroom/report_writer.h"
#include "app/commands/command_line.h"
#include "app/commands/command_unit.h"
#include "app/commands/standard_files.h"
#include "app/model/model_loader.h"

#include "ui/util/error_messages.h"
#include "ui/util/format_filters.h"

#include <QFileInfo>

namespace app
{
namespace
{
class ReportCommandMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::ReportCommand)
};

std::optional<ReportRequest> parseReportRequest(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(ReportCommandMessages::tr(
        "Writes a class report: for each model in a folder its picture, size and volume, whether it is print-ready or "
        "why not, and, for GLB files, the number of strokes and the time spent. Pupils' models are listed by pupil, "
        "with the time of the turn. Status 1: not all models can be read."));
    parser.addPositionalArgument(
        QStringLiteral("FOLDER"),
        ReportCommandMessages::tr("The models. Subfolders are skipped, except the pupils' models of a class."));
    CommandOptions::addOutput(parser, QStringLiteral("OUT.html|OUT.pdf"));
    CommandUnit::addTo(parser);
    StandardFiles::addTo(parser, ui::reportEndings());
    CommandOptions::addNoClobber(parser);
    const CommandOptions options(parser, QStringLiteral("report"), arguments);
    if (options.isAnswered())
        return std::nullopt;
    if (options.files().size() != 1)
        CommandLine::fail(ReportCommandMessages::tr("report: needs one folder; %n were given.", nullptr,
                                                    static_cast<int>(options.files().size())));
    options.requireFree(options.output());
    const QString out = StandardFiles::output(options, options.output(), ui::reportEndings());
    if (!ui::reportEndings().contains(QFileInfo(out).suffix().toLower()))
        CommandLine::fail(ui::ErrorMessages::notAReport(out));
    const double unit = CommandUnit::of(options);
    return ReportRequest{toPath(options.files().constFirst()), toPath(out), unit};
}
} // namespace

ExitStatus reportCommand(const QStringList& arguments)
{
    const std::optional<ReportRequest> request = parseReportRequest(arguments);
    if (!request)
        return Done;
    try {
        const QStringList unreadable = ReportWriter::run(*request);
        StandardFiles::flush();
        for (const QString& sentence : unreadable)
            CommandLine::printError(sentence);
        return unreadable.isEmpty() ? Done : AnswerIsNo;
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
}
} // namespace app
