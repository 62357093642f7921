// sheet: writes drawings of models for printing, one page each.
#include "app/commands/command_models.h"
#include "app/commands/command_unit.h"
#include "app/commands/standard_files.h"
#include "app/model/model_loader.h"

#include "core/analysis/mesh_check.h"
#include "core/io/mesh_io.h"
#include "core/mesh/draw_arrays.h"
#include "ui/drawing/sheet_book.h"
#include "ui/util/error_messages.h"
#include "ui/util/path_display.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace app
{
namespace
{
using ui::DrawingSheet; // lupdate misparses functions whose return type is written ui::DrawingSheet

class SheetMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::SheetCommand)
};

struct SheetOptions
{
    CommandModels models;
    QString out;
    double unit = 1; ///< unit of the files' coordinates, mm
    bool shaded = false;
};

std::optional<SheetOptions> parseSheetOptions(const QStringList& arguments)
{
    const QString shaded = QStringLiteral("shaded");
    QCommandLineParser parser;
    parser.setApplicationDescription(
        SheetMessages::tr("Writes scale drawings of models, one A4 page each, in the order of their names. Pupils' "
                          "models are named by pupil. Status 1: not all models can be drawn."));
    parser.addPositionalArgument(QStringLiteral("FILE..."), SheetMessages::tr("Models, or folders of models; or -."));
    CommandOptions::addOutput(parser, QStringLiteral("OUT.pdf"));
    CommandUnit::addTo(parser);
    parser.addOption({shaded, SheetMessages::tr("Draws colours under the lines.")});
    StandardFiles::addFrom(parser);
    CommandOptions::addNoClobber(parser);
    const CommandOptions given(parser, QStringLiteral("sheet"), arguments);
    if (given.isAnswered())
        return std::nullopt;
    SheetOptions options;
    options.unit = CommandUnit::of(given);
    options.shaded = given.has(shaded);
    options.out = given.output();
    given.requireFree(options.out);
    options.out = StandardFiles::output(given, options.out, {QStringLiteral("pdf")});
    if (QFileInfo(options.out).suffix().toLower() != QLatin1String("pdf"))
        CommandLine::fail(ui::ErrorMessages::notABook(options.out));
    options.models = commandModels(given);
    const QCollator collator = ui::nameCollator();
    std::ranges::stable_sort(options.models.files, [&collator](const FoundModel& a, const FoundModel& b) {
        const int byName = collator.compare(a.title(), b.title());
        return byName != 0 ? byName < 0 : a.file < b.file;
    });
    return options;
}

/// Returns the drawing of a model. Throws CommandFailure if the surface is not closed: lines would be missing, and the
/// volume would be meaningless.
DrawingSheet sheetOf(const SheetOptions& options, const FoundModel& model)
{
    const QString name = ui::displayName(model.file);
    core::TriangleMesh mesh = core::readMesh(model.file);
    if (options.unit != 1)
        CommandUnit::scale(name, mesh, options.unit);
    const core::MeshReport report = core::checkMesh(mesh);
    if (!report.closed || !report.oriented)
        CommandLine::fail(SheetMessages::tr("%1 has no sheet, because its surface does not enclose anything (%2).")
                              .arg(name, ui::ErrorMessages::faults(report)));
    auto drawing = core::drawLines(core::drawArraysOf(mesh), ui::sheetDetail(options.shaded), {});
    return {model.title(), QDate::currentDate(), *std::move(drawing), options.shaded};
}

/// Adds a page for each model. Models that cannot be drawn are reported on standard error.
ExitStatus addSheets(ui::SheetBook& book, const SheetOptions& options)
{
    ExitStatus status = options.models.status == Done ? Done : AnswerIsNo;
    const auto leaveOut = [&status](const QString& sentence) {
        CommandLine::printError(sentence);
        status = AnswerIsNo;
    };
    for (const FoundModel& model : options.models.files) {
        try {
            book.add(sheetOf(options, model));
        } catch (const core::FileError& error) {
            leaveOut(ui::ErrorMessages::sentence(error));
        } catch (const CommandFailure& failure) {
            leaveOut(failure.sentence);
        }
    }
    return status;
}
} // namespace

ExitStatus sheetCommand(const QStringList& arguments)
{
    const std::optional<SheetOptions> options = parseSheetOptions(arguments);
    if (!options)
        return Done;
    try {
        ui::SheetBook book(toPath(options->out), QFileInfo(options->out).completeBaseName());
        const ExitStatus status = addSheets(book, *options);
        if (book.isEmpty())
            CommandLine::fail(SheetMessages::tr("%1 was not written: none of the models can be drawn.")
                                  .arg(QDir::toNativeSeparators(options->out)));
        book.commit();
        StandardFiles::flush();
        return status;
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
}
} // namespace app
