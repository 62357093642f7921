// convert: reads, checks, scales if requested, checks again, and writes a model. A model that is not sound is refused,
// or repaired if requested.
#include "app/commands/command_line.h"
#include "app/commands/command_models.h"
#include "app/commands/command_unit.h"
#include "app/commands/standard_files.h"
#include "app/model/model_export.h"
#include "app/model/model_loader.h"

#include "core/analysis/mesh_check.h"
#include "core/decimation/decimate.h"
#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice_placement.h"
#include "core/io/mesh_io.h"
#include "core/io/placed_mesh.h"
#include "core/mesh/mesh_builder.h"
#include "core/parts/part_split.h"
#include "core/repair/repair.h"
#include "ui/util/error_messages.h"
#include "ui/util/number_format.h"
#include "ui/util/repair_messages.h"

namespace app
{
namespace
{
using core::UpAxis; // lupdate misparses functions whose return type is written core::UpAxis

class ConvertMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::ConvertCommand)
};

constexpr double minSize = 0.001, maxSize = 1e6; ///< smallest and largest length allowed in options, mm
constexpr unsigned fewestTriangles = 4;          ///< least number of triangles of a solid
const QString repairOption = QStringLiteral("repair"), wrap = QStringLiteral("wrap"),
              largeHoles = QStringLiteral("large-holes"), innerParts = QStringLiteral("inner-parts"),
              partsOption = QStringLiteral("parts"), overlaps = QStringLiteral("overlaps"),
              recentre = QStringLiteral("recentre");

struct ConvertOptions
{
    QString in, out;
    double unit = 1;            ///< unit of IN's coordinates, mm
    std::optional<double> size; ///< longest side of OUT, mm
    std::optional<UpAxis> up;   ///< up axis of IN
    bool recentres = false;     ///< moves the middle of the model to the origin
    std::size_t triangles = 0;  ///< largest number of triangles of OUT; 0: no limit
    std::optional<core::RepairOptions> repair;
    bool keepsObjects = false; ///< makes a part of each object of IN
    bool joinsParts = true;    ///< unites parts that overlap, if OUT has one surface or is for print
};

// Allowed words of options; the first word is the default.
QStringList holeWords()
{
    return {QStringLiteral("fill"), QStringLiteral("refuse")};
}

QStringList partWords()
{
    return {QStringLiteral("fill"), QStringLiteral("hollow")};
}

QStringList overlapWords()
{
    return {QStringLiteral("unite"), QStringLiteral("keep")};
}

QStringList upWords()
{
    return {QStringLiteral("y"), QStringLiteral("z")};
}

void addConvertOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(
        ConvertMessages::tr("Writes a model in another format, unit or size. OUT is in mm."));
    parser.addPositionalArgument(QStringLiteral("IN"), ConvertMessages::tr("The model to read; or -."));
    parser.addPositionalArgument(QStringLiteral("OUT"),
                                 ConvertMessages::tr("The file to write, in the format of its ending; or -."));
    CommandUnit::addTo(parser);
    parser.addOptions(
        {{QStringLiteral("size"), ConvertMessages::tr("Length of the longest side in mm (default: as it is)."),
          QStringLiteral("MM")},
         {QStringLiteral("up"),
          ConvertMessages::tr("Axis of IN that points up (default: z for STL, 3MF and AMF, y for others)."),
          upWords().join(u'|')},
         {{recentre, QStringLiteral("recenter")}, ConvertMessages::tr("Move the middle of the model to the origin.")},
         {QStringLiteral("triangles"),
          ConvertMessages::tr("Most triangles of OUT, 4 or more (default: as many as it has). They are removed where "
                              "shape and colours change least."),
          QStringLiteral("N")},
         {{repairOption, QStringLiteral("legalise"), QStringLiteral("legalize")},
          ConvertMessages::tr("Repair a model that is not watertight, and say what changed.")},
         {wrap, ConvertMessages::tr(
                    "With --repair: make a new surface if the model cannot be kept otherwise; detail is lost.")},
         {largeHoles,
          ConvertMessages::tr("With --repair: what to do with holes longer than a quarter of the model (default: "
                              "fill)."),
          holeWords().join(u'|')},
         {innerParts,
          ConvertMessages::tr("With --repair: what to do with parts inside of others that face outwards (default: "
                              "fill)."),
          partWords().join(u'|')},
         {partsOption, ConvertMessages::tr("Make a part of each object of IN; parts may overlap.")},
         {overlaps,
          ConvertMessages::tr("What to do with parts that overlap if OUT is STL, PLY, OFF or 3MF (default: unite)."),
          overlapWords().join(u'|')}});
    StandardFiles::addFrom(parser);
    StandardFiles::addTo(parser);
    CommandOptions::addNoClobber(parser);
}

std::optional<core::RepairOptions> repairFrom(const CommandOptions& given)
{
    given.requireWith({wrap, largeHoles, innerParts}, repairOption);
    if (!given.has(repairOption))
        return std::nullopt;
    core::RepairOptions repair;
    repair.canWrap = given.has(wrap);
    repair.fillLargeHoles = given.choice(largeHoles, holeWords()) == 0;
    repair.innerAreCavities = given.choice(innerParts, partWords()) == 1;
    return repair;
}

std::optional<ConvertOptions> parseConvertOptions(const QStringList& arguments)
{
    const QString size = QStringLiteral("size"), up = QStringLiteral("up"), triangles = QStringLiteral("triangles");
    QCommandLineParser parser;
    addConvertOptions(parser);
    const CommandOptions given(parser, QStringLiteral("convert"), arguments);
    if (given.isAnswered())
        return std::nullopt;
    const QStringList files = given.files();
    if (files.size() != 2)
        CommandLine::fail(ConvertMessages::tr("convert: needs two files, IN and OUT; %n were given.", nullptr,
                                              static_cast<int>(files.size())));
    ConvertOptions options{{}, {}, CommandUnit::of(given), {}, {}, given.has(recentre), 0, repairFrom(given)};
    if (given.has(size))
        options.size = given.number(size, minSize, maxSize);
    if (given.has(up))
        options.up = given.choice(up, upWords()) == 0 ? UpAxis::Y : UpAxis::Z;
    if (given.has(triangles))
        options.triangles = given.wholeNumber(triangles, fewestTriangles);
    options.keepsObjects = given.has(partsOption);
    if (given.has(overlaps))
        options.joinsParts = given.choice(overlaps, overlapWords()) == 0;
    given.requireFree(files[1]);
    options.out = StandardFiles::output(given, files[1]);
    CommandLine::requireMeshEnding(options.out);
    options.in = StandardFiles::input(given, files[0]);
    return options;
}

/// Returns whether IN would be sound if a part were made of each of its objects. Reads it again.
bool isSoundAsParts(const ConvertOptions& options)
{
    const core::ReadResult read = core::readModel(toPath(options.in), {.up = options.up, .keepsObjects = true});
    return read.parts.size() > 1 && core::checkMesh(read.mesh).printReady();
}

/// Fails if the model is not sound. `hasObjects`: whether its file has several objects, which were read as one part.
void requireSound(const ConvertOptions& options, const core::TriangleMesh& mesh, bool hasObjects = false)
{
    const core::MeshReport report = core::checkMesh(mesh);
    if (report.printReady())
        return;
    const QString hint = hasObjects && isSoundAsParts(options)
                             ? ConvertMessages::tr("--parts keeps its objects apart, which may overlap then; "
                                                   "--repair may make it watertight.")
                             : ConvertMessages::tr("--repair may make it watertight.");
    throw CommandFailure{ui::ErrorMessages::refusal(options.in, report) + u' ' + hint, AnswerIsNo};
}

/// Drops hidden parts if OUT cannot keep them hidden.
void dropHidden(const ConvertOptions& options, core::TriangleMesh& mesh, const core::PartList& parts)
{
    if (core::holdsHiddenParts(*core::meshFormatOf(toPath(options.out))))
        return;
    mesh = core::visibleParts(mesh, parts);
    if (mesh.triangles.empty())
        throw CommandFailure{ConvertMessages::tr("%1: all its parts are hidden, and only GLB keeps hidden parts. "
                                                 "Nothing was written.")
                                 .arg(options.in),
                             AnswerIsNo};
}

/// Unites the parts if they overlap and OUT cannot keep them apart. Returns whether it did.
bool joinParts(const ConvertOptions& options, core::TriangleMesh& mesh)
{
    using core::PartUnion;
    const PartUnion done = options.joinsParts ? unitePartsFor(options.out, mesh) : PartUnion::NotNeeded;
    if (done == PartUnion::Failed)
        throw CommandFailure{ConvertMessages::tr("%1: its parts overlap and cannot be united. --overlaps keep writes "
                                                 "them as they are.")
                                 .arg(options.in),
                             AnswerIsNo};
    return done == PartUnion::Done;
}

QString refusalText(const QString& file, const core::RepairResult& repaired, const core::RepairOptions& options)
{
    const QString refusal = ui::RepairMessages::refusal(file, repaired);
    const bool mayWrap =
        repaired.refusal == core::RepairRefusal::Unresolved || repaired.refusal == core::RepairRefusal::TooMuchLost;
    return mayWrap && !options.canWrap ? refusal + u' ' + ConvertMessages::tr("--wrap may make a new surface.")
                                       : refusal;
}

/// A completed repair. It is reported after decimation, which may change the losses.
struct Repaired
{
    core::RepairReport report;
    core::TriangleMesh old; ///< the mesh before the repair; see core::RepairResult::old
    QString doubt;    ///< one sentence if the repaired model may differ too much from the original; otherwise empty
    core::Vec3 place; ///< place of `old` in the coordinates of the mesh
};

/// Repairs the model if it is not sound. Returns nothing if it was sound already.
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
    const core::Vec3 place = options.recentres ? core::Vec3::Zero() : core::Vec3(-repaired.report.moved);
    mesh = core::placedMesh(toPath(options.out), std::move(*repaired.mesh), place);
    return Repaired{repaired.report, std::move(repaired.old), ui::RepairMessages::doubt(file, repaired.report), place};
}

/// Measures the losses again after decimation, replacing those of the repair alone.
void measureAgain(const QString& file, Repaired& repaired, core::TriangleMesh mesh)
{
    for (core::Vec3f& p : mesh.points)
        p = (p.cast<double>() - repaired.place).cast<float>();
    core::measureAgain(repaired.report, repaired.old, mesh);
    if (const QString doubt = ui::RepairMessages::doubt(file, repaired.report);
        !repaired.doubt.isEmpty() && !doubt.isEmpty())
        repaired.doubt = doubt;
}

void printRepair(const core::RepairReport& report)
{
    const QStringList steps = ui::RepairMessages::steps(report) + ui::RepairMessages::losses(report);
    CommandLine::printRemark(steps.join(QLatin1Char('\n')) + QLatin1Char('\n'));
}

double scaleFor(const ConvertOptions& options, const core::TriangleMesh& mesh)
{
    if (!options.size)
        return options.unit;
    return *options.size / core::boxOf(mesh).sizes().maxCoeff();
}

/// Returns a sentence about a model that could not be decimated to the requested number of triangles.
QString tooManyText(const QString& file, const core::TriangleMesh& few, std::size_t asked)
{
    const std::size_t needed = core::fewestTriangles(few);
    const QString sentence =
        needed > asked
            ? ConvertMessages::tr("%1 could be reduced to %2 triangles, not to %3: its holes and parts need at least "
                                  "%4. Nothing was written.")
                  .arg(file, ui::number(few.triangles.size()), ui::number(asked), ui::number(needed))
            : ConvertMessages::tr("%1 could be reduced to %2 triangles, not to %3: with fewer, no surface was found "
                                  "that keeps its holes open and does not intersect itself. Nothing was written.")
                  .arg(file, ui::number(few.triangles.size()), ui::number(asked));
    return sentence;
}

/// Decimates the mesh to options.triangles, on the lattice that the window would choose for it.
core::TriangleMesh reduced(const ConvertOptions& options, const core::TriangleMesh& mesh)
{
    core::BuildResult built = core::buildMesh(mesh);
    if (!built.mesh)
        throw CommandFailure{ui::ErrorMessages::tooFine(options.in, built.unsnappable), AnswerIsNo};
    const core::Vec3 place = built.mesh->frame().place;
    const core::Lattice lattice = built.mesh->lattice();
    core::TriangleMesh few = mesh.parts.empty()
                                 ? core::decimate(std::move(*built.mesh), options.triangles).mesh
                                 : core::decimateEachPart(core::extractMesh(*built.mesh), lattice, options.triangles);
    if (few.triangles.size() > options.triangles)
        throw CommandFailure{tooManyText(options.in, few, options.triangles), AnswerIsNo};
    return core::placedMesh(toPath(options.out), std::move(few), place);
}

/// Moves the middle of the model's box to the origin, by a vector of the lattice that the window would choose for it.
/// Returns the vector.
core::Vec3 moveToOrigin(const ConvertOptions& options, core::TriangleMesh& mesh)
{
    const core::Vec3 moved = core::placeOnLattice(core::boxOf(mesh), true).moved;
    mesh = core::placedMesh(toPath(options.out), std::move(mesh), moved);
    return moved;
}

QString sentence(const core::FileError& error, const ConvertOptions& options)
{
    const QString words = ui::ErrorMessages::sentence(error);
    const bool mayHelp = error.kind == core::FileErrorKind::TooFar && !options.recentres;
    return mayHelp ? words + u' ' + ConvertMessages::tr("--recentre does that.") : words;
}
} // namespace

ExitStatus convertCommand(const QStringList& arguments)
{
    const std::optional<ConvertOptions> options = parseConvertOptions(arguments);
    if (!options)
        return Done;
    try {
        auto [mesh, remarks, parts] =
            core::readModel(toPath(options->in), {.up = options->up, .keepsObjects = options->keepsObjects});
        if (!options->repair)
            requireSound(*options, mesh, remarks.objects > 1 && !options->keepsObjects);
        if (const double factor = scaleFor(*options, mesh); factor != 1) {
            CommandUnit::scale(options->in, mesh, factor);
            if (!options->repair)
                requireSound(*options, mesh);
        }
        std::optional<Repaired> repaired;
        if (options->repair)
            repaired = makeSound(*options, mesh);
        if (repaired && parts.size() > 1)
            parts = {}; // the repair made one part of all
        dropHidden(*options, mesh, parts);
        if (options->recentres) {
            const core::Vec3 moved = moveToOrigin(*options, mesh);
            if (repaired)
                repaired->place += moved;
        }
        const bool areJoined = joinParts(*options, mesh);
        if (areJoined)
            parts = {};
        if (options->triangles > 0 && mesh.triangles.size() > options->triangles) {
            mesh = reduced(*options, mesh);
            if (repaired)
                measureAgain(options->in, *repaired, mesh);
        }
        if (repaired)
            printRepair(repaired->report);
        if (areJoined)
            CommandLine::printRemark(ConvertMessages::tr("The parts overlap, so they were united.") + u'\n');
        core::writeMesh(toPath(options->out), mesh, {.parts = parts});
        StandardFiles::flush();
        if (const QString left = ui::ErrorMessages::remarks(options->in, remarks); !left.isEmpty())
            CommandLine::printError(left);
        if (repaired && !repaired->doubt.isEmpty())
            throw CommandFailure{repaired->doubt, AnswerIsNo};
    } catch (const core::FileError& error) {
        CommandLine::fail(sentence(error, *options));
    }
    return Done;
}
} // namespace app
