// report: a page for whoever judges a folder of models.
#include "app/classroom/report_writer.h"
#include "app/commands/command_line.h"
#include "app/commands/command_unit.h"
#include "app/model/model_loader.h"

#include "ui/util/error_messages.h"
#include "ui/util/format_filters.h"

#include <QFileInfo>

namespace app
{
namespace
{
class ReportWords
{
    Q_DECLARE_TR_FUNCTIONS(app::ReportCommand)
};

std::optional<ReportOrder> parseReportOrder(const QStringList& arguments)
{
    const QString name = QStringLiteral("report"), unit = QStringLiteral("unit");
    QCommandLineParser parser;
    parser.setApplicationDescription(
        ReportWords::tr("Writes a class report: of each model in a folder its picture, size and volume, whether it is "
                        "print-ready or why not, and, of GLB files, the strokes and the time that it took."));
    parser.addPositionalArgument(QStringLiteral("FOLDER"),
                                 ReportWords::tr("The models; folders further down are not looked at."));
    CommandLine::addOutput(parser, QStringLiteral("OUT.html|OUT.pdf"));
    parser.addOption({unit, ReportWords::tr("What the files are measured in; else mm."), CommandUnit::words()});
    if (!CommandLine::parse(parser, name, arguments))
        return std::nullopt;
    if (parser.positionalArguments().size() != 1)
        CommandLine::fail(ReportWords::tr("report: one folder is needed, but %n were given.", nullptr,
                                          static_cast<int>(parser.positionalArguments().size())));
    const QString out = CommandLine::output(parser, name);
    if (!ui::reportEndings().contains(QFileInfo(out).suffix().toLower()))
        CommandLine::fail(ui::ErrorMessages::notAReport(out));
    ReportOrder order{toPath(parser.positionalArguments().constFirst()), toPath(out)};
    if (parser.isSet(unit))
        order.unit = CommandUnit::named(name, parser.value(unit));
    return order;
}
} // namespace

ExitStatus reportCommand(const QStringList& arguments)
{
    const std::optional<ReportOrder> order = parseReportOrder(arguments);
    if (!order)
        return Done;
    try {
        ReportMaker::run(*order);
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
    return Done;
}
} // namespace app
