// convert: read, check, scale if asked to, check again, write. A model that is not sound is not written, or is repaired
// if asked to.
#include "app/commands/command_line.h"
#include "app/commands/command_unit.h"
#include "app/model/model_loader.h"

#include "core/analysis/mesh_check.h"
#include "core/geometry/face_geometry.h"
#include "core/io/mesh_io.h"
#include "core/io/placed_mesh.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/decimate.h"
#include "core/repair/repair.h"
#include "ui/util/error_messages.h"
#include "ui/util/number_format.h"
#include "ui/util/repair_messages.h"

#include <QLocale>

#include <cmath>

namespace app
{
namespace
{
using core::UpAxis; // lupdate would lose its place at a function that returns a core::UpAxis

class ConvertMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::ConvertCommand)
};

struct ConvertOptions
{
    QString in, out;
    std::optional<double> unit; ///< of IN, in mm
    std::optional<double> size; ///< of OUT's longest side, mm
    std::optional<UpAxis> up;   ///< of IN
    std::size_t triangles = 0;  ///< OUT has at most so many; 0: all
    std::optional<core::RepairOptions> repair;
};

double sizeFrom(const QString& word)
{
    bool isNumber = false;
    const double size = QLocale::c().toDouble(word, &isNumber);
    if (!isNumber || !std::isfinite(size) || size <= 0)
        CommandLine::fail(
            ConvertMessages::tr("convert: --size is a length in millimetres, more than 0, not %1.").arg(word));
    return size;
}

unsigned trianglesFrom(const QString& word)
{
    bool isNumber = false;
    const unsigned triangles = QLocale::c().toUInt(word, &isNumber);
    if (!isNumber || triangles < 4)
        CommandLine::fail(ConvertMessages::tr("convert: --triangles is a whole number, at least 4, not %1.").arg(word));
    return triangles;
}

UpAxis upNamed(const QString& word)
{
    if (word != QLatin1String("y") && word != QLatin1String("z"))
        CommandLine::fail(ConvertMessages::tr("convert: --up is y or z, not %1.").arg(word));
    return word == QLatin1String("y") ? UpAxis::Y : UpAxis::Z;
}

/// True for the first word.
bool isFirstOf(const QString& option, const QString& first, const QString& second, const QString& word)
{
    if (word != first && word != second)
        CommandLine::fail(ConvertMessages::tr("convert: --%1 is %2 or %3, not %4.").arg(option, first, second, word));
    return word == first;
}

std::optional<ConvertOptions> parseConvertOptions(const QStringList& arguments)
{
    const QString unit = QStringLiteral("unit"), size = QStringLiteral("size"), up = QStringLiteral("up"),
                  triangles = QStringLiteral("triangles"), legaliseOption = QStringLiteral("legalise"),
                  wrap = QStringLiteral("wrap"), largeHoles = QStringLiteral("large-holes"),
                  innerParts = QStringLiteral("inner-parts"), fill = QStringLiteral("fill"),
                  refuse = QStringLiteral("refuse"), hollow = QStringLiteral("hollow");
    QCommandLineParser parser;
    parser.setApplicationDescription(ConvertMessages::tr("Writes a model in another format, unit or size."));
    parser.addPositionalArgument(QStringLiteral("IN"), ConvertMessages::tr("The model to read."));
    parser.addPositionalArgument(QStringLiteral("OUT"),
                                 ConvertMessages::tr("Where it goes; the ending says the format."));
    parser.addOptions(
        {{unit, ConvertMessages::tr("What IN is measured in; OUT is in mm."), CommandUnit::words()},
         {size, ConvertMessages::tr("How long the longest side becomes."), QStringLiteral("MM")},
         {up, ConvertMessages::tr("Which axis of IN points up; else z for STL, 3MF and AMF, y for others."),
          QStringLiteral("y|z")},
         {triangles,
          ConvertMessages::tr("OUT has at most so many triangles; where they go, shape and colours lose least."),
          QStringLiteral("N")},
         {legaliseOption, ConvertMessages::tr("Mends a model that is not in order, and says what changed.")},
         {wrap, ConvertMessages::tr("With --legalise: makes the whole surface anew where nothing else keeps it; detail "
                                    "is lost.")},
         {largeHoles, ConvertMessages::tr("With --legalise: holes longer than a quarter of the model; else fill."),
          QStringLiteral("fill|refuse")},
         {innerParts, ConvertMessages::tr("With --legalise: parts inside of others that face outwards; else fill."),
          QStringLiteral("fill|hollow")}});
    if (!CommandLine::parse(parser, QStringLiteral("convert"), arguments))
        return std::nullopt;
    const QStringList files = parser.positionalArguments();
    if (files.size() != 2)
        CommandLine::fail(ConvertMessages::tr("convert: two files are needed, IN and OUT, but %n were given.", nullptr,
                                              static_cast<int>(files.size())));
    ConvertOptions options{files[0], files[1], {}, {}, {}, 0, {}};
    if (parser.isSet(unit))
        options.unit = CommandUnit::named(QStringLiteral("convert"), parser.value(unit));
    if (parser.isSet(size))
        options.size = sizeFrom(parser.value(size));
    if (parser.isSet(up))
        options.up = upNamed(parser.value(up));
    if (parser.isSet(triangles))
        options.triangles = trianglesFrom(parser.value(triangles));
    if (parser.isSet(legaliseOption))
        options.repair.emplace();
    else if (parser.isSet(wrap) || parser.isSet(largeHoles) || parser.isSet(innerParts))
        CommandLine::fail(ConvertMessages::tr("convert: --wrap, --large-holes and --inner-parts are for --legalise."));
    if (parser.isSet(wrap))
        options.repair->canWrap = true;
    if (parser.isSet(largeHoles))
        options.repair->fillLargeHoles = isFirstOf(largeHoles, fill, refuse, parser.value(largeHoles));
    if (parser.isSet(innerParts))
        options.repair->innerAreCavities = !isFirstOf(innerParts, fill, hollow, parser.value(innerParts));
    return options;
}

void requireSound(const QString& file, const core::TriangleMesh& mesh)
{
    const core::MeshReport report = core::checkMesh(mesh);
    if (!report.printReady())
        throw CommandFailure{ui::ErrorMessages::refusal(file, report) + u' ' +
                                 ConvertMessages::tr("--legalise may mend it."),
                             AnswerIsNo};
}

QString refusalText(const QString& file, const core::RepairResult& repaired, const core::RepairOptions& options)
{
    const QString refusal = ui::RepairMessages::refusal(file, repaired);
    const bool mayWrap =
        repaired.refusal == core::RepairRefusal::Unresolved || repaired.refusal == core::RepairRefusal::TooMuchLost;
    return mayWrap && !options.canWrap ? refusal + u' ' + ConvertMessages::tr("--wrap may make its surface anew.")
                                       : refusal;
}

/// A repair of the model, to be told of once it is known what was written.
struct Repaired
{
    core::RepairReport report;
    core::TriangleMesh old; ///< see core::RepairResult
    QString doubt;          ///< why the outcome may not be the model any more; empty if it is
};

/// Repairs a model that is not in order.
std::optional<Repaired> makeSound(const ConvertOptions& options, core::TriangleMesh& mesh)
{
    const QString& file = options.in;
    if (core::checkMesh(mesh).printReady())
        return std::nullopt;
    const auto onStep = [&](core::RepairStep step) {
        CommandLine::printProgress(ui::RepairMessages::progress(file, step));
    };
    core::RepairResult repaired = core::repairMesh(mesh, *options.repair, {}, onStep);
    CommandLine::printProgress({});
    if (!repaired.mesh)
        throw CommandFailure{refusalText(file, repaired, *options.repair), AnswerIsNo};
    mesh = core::placedMesh(toPath(options.out), std::move(*repaired.mesh), -repaired.report.moved);
    return Repaired{repaired.report, std::move(repaired.old), ui::RepairMessages::doubt(file, repaired.report)};
}

/// Measures what was made of the repaired model in place of the repair's own outcome.
void measureAgain(const QString& file, Repaired& repaired, core::TriangleMesh mesh)
{
    for (core::Vec3f& p : mesh.points)
        p = (p.cast<double>() + repaired.report.moved).cast<float>();
    core::measureAgain(repaired.report, repaired.old, mesh);
    if (const QString doubt = ui::RepairMessages::doubt(file, repaired.report);
        !repaired.doubt.isEmpty() && !doubt.isEmpty())
        repaired.doubt = doubt;
}

void printRepair(const core::RepairReport& report)
{
    const QStringList steps = ui::RepairMessages::steps(report) + ui::RepairMessages::losses(report);
    CommandLine::print(steps.join(QLatin1Char('\n')) + QLatin1Char('\n'));
}

double scaleFor(const ConvertOptions& options, const core::TriangleMesh& mesh)
{
    if (!options.size)
        return options.unit.value_or(1);
    return *options.size / core::boxOf(mesh).sizes().maxCoeff();
}

/// Returns the sentence about a model that has more triangles than were asked for.
QString tooManyText(const QString& file, const core::TriangleMesh& few, std::size_t asked)
{
    const std::size_t needed = core::fewestTriangles(few);
    const QString sentence =
        needed > asked ? ConvertMessages::tr("%1 could be brought down to %2 triangles, not to %3: its holes and parts "
                                             "need at least %4. Nothing was written.")
                             .arg(file, ui::number(few.triangles.size()), ui::number(asked), ui::number(needed))
                       : ConvertMessages::tr("%1 could be brought down to %2 triangles, not to %3: with fewer, no "
                                             "surface was found whose faces do not meet and whose holes stay open. "
                                             "Nothing was written.")
                             .arg(file, ui::number(few.triangles.size()), ui::number(asked));
    return sentence;
}

/// On the lattice that an import would choose.
core::TriangleMesh reduced(const ConvertOptions& options, const core::TriangleMesh& mesh)
{
    core::BuildResult built = core::buildMesh(mesh);
    if (!built.mesh)
        throw CommandFailure{ui::ErrorMessages::tooFine(options.in, built.unsnappable), AnswerIsNo};
    const core::Vec3 place = built.mesh->frame().place;
    core::Decimated few = core::decimate(std::move(*built.mesh), options.triangles);
    if (few.mesh.triangles.size() > options.triangles)
        throw CommandFailure{tooManyText(options.in, few.mesh, options.triangles), AnswerIsNo};
    return core::placedMesh(toPath(options.out), std::move(few.mesh), place);
}
} // namespace

ExitStatus convertCommand(const QStringList& arguments)
{
    const std::optional<ConvertOptions> options = parseConvertOptions(arguments);
    if (!options)
        return Done;
    CommandLine::requireMeshEnding(options->out);
    try {
        auto [mesh, remarks] = core::readModel(toPath(options->in), {options->up});
        if (!options->repair)
            requireSound(options->in, mesh);
        if (const double factor = scaleFor(*options, mesh); factor != 1) {
            CommandUnit::scale(options->in, mesh, factor);
            if (!options->repair)
                requireSound(options->in, mesh);
        }
        std::optional<Repaired> repaired;
        if (options->repair)
            repaired = makeSound(*options, mesh);
        if (options->triangles > 0 && mesh.triangles.size() > options->triangles) {
            mesh = reduced(*options, mesh);
            if (repaired)
                measureAgain(options->in, *repaired, mesh);
        }
        if (repaired)
            printRepair(repaired->report);
        core::writeMesh(toPath(options->out), mesh);
        if (const QString left = ui::ErrorMessages::remarks(options->in, remarks); !left.isEmpty())
            CommandLine::printError(left);
        if (repaired && !repaired->doubt.isEmpty())
            throw CommandFailure{repaired->doubt, AnswerIsNo};
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
    return Done;
}
} // namespace app
