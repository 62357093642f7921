// replay: strokes and commands from a file on a model from a file, or on the paper's sphere; what came of it to files.
// In order: check all input (what stands after a command, when the model is as that leaves it), sculpt, write. Nothing
// is written when anything is wrong.
#include "app/commands/command_line.h"
#include "app/commands/replay_stats.h"
#include "app/commands/stroke_assets.h"
#include "app/document/time_lapse.h"
#include "app/model/command_names.h"
#include "app/model/model_change_job.h"
#include "app/model/model_loader.h"
#include "app/platform/process_usage.h"

#include "core/analysis/mesh_check.h"
#include "core/geometry/face_geometry.h"
#include "core/io/mesh_io.h"
#include "core/io/placed_mesh.h"
#include "core/io/stroke/stroke_file.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/stroke_coordinates.h"
#include "ui/util/error_messages.h"
#include "ui/util/stroke_file_messages.h"

#include <QFile>

#include <filesystem>
#include <map>
#include <utility>

namespace app
{
namespace
{
constexpr double paperRadius = 1;
constexpr int frameWidth = 1280, frameHeight = 720;

class ReplayMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::ReplayCommand)
};

/// The engine has no way around its own verification yet: None keeps its word about --out, and costs what Local does.
enum class Verify { Local, Full, None };

struct ReplayOptions
{
    QString strokes, in, out, stats;
    QString frames; ///< a folder; empty: no pictures
    int every = 1;
    Verify verify = Verify::Local;
};

Verify verifyNamed(const QString& word)
{
    if (word == QLatin1String("full"))
        return Verify::Full;
    if (word == QLatin1String("none"))
        return Verify::None;
    if (word != QLatin1String("local"))
        CommandLine::fail(ReplayMessages::tr("replay: --verify is local, full or none, not %1.").arg(word));
    return Verify::Local;
}

int everyNamed(const QString& word)
{
    bool isNumber = true;
    const int every = word.isEmpty() ? 1 : word.toInt(&isNumber);
    if (!isNumber || every < 1)
        CommandLine::fail(ReplayMessages::tr("replay: --every is a whole number from 1 on, not %1.").arg(word));
    return every;
}

std::optional<ReplayOptions> parseReplayOptions(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        ReplayMessages::tr("Plays recorded strokes on a model, or on the paper's sphere."));
    parser.addOptions(
        {{QStringLiteral("strokes"), ReplayMessages::tr("The strokes, JSON."), QStringLiteral("S.json")},
         {QStringLiteral("in"), ReplayMessages::tr("The model; without it, a sphere of 2562 vertices, radius 1."),
          QStringLiteral("FILE")},
         {QStringLiteral("out"), ReplayMessages::tr("Where the sculpted model goes."), QStringLiteral("FILE")},
         {QStringLiteral("stats"), ReplayMessages::tr("Where cost and outcome of each dab go, JSON."),
          QStringLiteral("T.json")},
         {QStringLiteral("frames"),
          ReplayMessages::tr("A folder for pictures of the model, PNG, at the start and after each stroke."),
          QStringLiteral("FOLDER")},
         {QStringLiteral("every"), ReplayMessages::tr("Strokes from one picture to the next."), QStringLiteral("N")},
         {QStringLiteral("verify"),
          ReplayMessages::tr(
              "local: what changed (as in the window); full: the whole mesh after each dab as well; none: "
              "for measurements, excludes --out."),
          QStringLiteral("local|full|none"), QStringLiteral("local")}});
    if (!CommandLine::parse(parser, QStringLiteral("replay"), arguments))
        return std::nullopt;
    ReplayOptions options{parser.value(QStringLiteral("strokes")),
                          parser.value(QStringLiteral("in")),
                          parser.value(QStringLiteral("out")),
                          parser.value(QStringLiteral("stats")),
                          parser.value(QStringLiteral("frames")),
                          everyNamed(parser.value(QStringLiteral("every"))),
                          verifyNamed(parser.value(QStringLiteral("verify")))};
    if (!parser.positionalArguments().isEmpty())
        CommandLine::fail(ReplayMessages::tr("replay: %1 is no option; the model is given with --in.")
                              .arg(parser.positionalArguments().first()));
    if (options.strokes.isEmpty())
        CommandLine::fail(ReplayMessages::tr("replay: --strokes is missing."));
    if (options.frames.isEmpty() && parser.isSet(QStringLiteral("every")))
        CommandLine::fail(
            ReplayMessages::tr("replay: --every says how many strokes there are to a picture, and needs --frames."));
    if (options.verify == Verify::None && parser.isSet(QStringLiteral("out")))
        CommandLine::fail(ReplayMessages::tr(
            "replay: --verify none and --out exclude each other: what is not verified is not kept."));
    return options;
}

/// A slip that would cost the strokes or the model.
void requireDifferentFiles(const ReplayOptions& options)
{
    const std::pair<QString, QString> files[] = {{QStringLiteral("--strokes"), options.strokes},
                                                 {QStringLiteral("--in"), options.in},
                                                 {QStringLiteral("--out"), options.out},
                                                 {QStringLiteral("--stats"), options.stats}};
    std::map<std::filesystem::path, QString> seen;
    for (const auto& [option, file] : files) {
        if (file.isEmpty())
            continue;
        std::error_code problem; // then the path is empty: what is wrong with it is told where it is used
        const std::filesystem::path path = std::filesystem::weakly_canonical(toPath(file), problem);
        const auto [other, isNew] = seen.emplace(path, option);
        if (!isNew && !path.empty())
            CommandLine::fail(
                ReplayMessages::tr("replay: %1 and %2 name the same file, %3.").arg(other->second, option, file));
    }
}

std::vector<core::FileEntry> readStrokes(const QString& path)
{
    try {
        return core::readStrokes(QFile::encodeName(path).toStdString());
    } catch (const core::StrokeFileError& error) {
        throw CommandFailure{ui::StrokeFileMessages::sentence(path, error)};
    }
}

using Entries = std::vector<core::FileEntry>;

/// Reads the models to be inserted; their paths start from the stroke file.
void readInserted(Entries& entries, const QString& strokes)
{
    for (core::FileEntry& entry : entries) {
        auto* const command = std::get_if<core::FileCommand>(&entry);
        if (auto* const insertion = command ? std::get_if<core::Insert>(&command->command) : nullptr)
            insertion->model = core::readMesh(toPath(strokes).parent_path() / command->file);
    }
}

/// Puts the strokes from `first` on, up to the next command, into the document's coordinates, and checks them against
/// the model: a command may give it another place and lattice.
void takeStrokes(const core::Mesh& mesh, const core::StrokeCoordinates& coordinates, Entries& entries,
                 std::size_t first, const QString& path)
{
    for (std::size_t i = first; i < entries.size() && std::holds_alternative<core::Stroke>(entries[i]); ++i) {
        auto& stroke = std::get<core::Stroke>(entries[i]);
        stroke = coordinates.inDocument(stroke, mesh);
        try {
            core::requireFit(stroke, mesh.lattice(), coordinates.offset(mesh));
        } catch (core::StrokeFileError& error) {
            error.stroke = i;
            throw CommandFailure{ui::StrokeFileMessages::sentence(path, error)};
        }
    }
}

/// `dab`: the one that is being done, from 0.
void requireWhole(const core::Sculptor& sculptor, std::size_t dab)
{
    if (!core::checkMesh(core::extractMesh(sculptor.mesh())).printReady())
        throw CommandFailure{ReplayMessages::tr("replay: the mesh is not in order in dab %1.").arg(dab), AnswerIsNo};
}

core::MeshDelta play(core::Sculptor& sculptor, const core::Stroke& stroke, double& dabStart)
{
    sculptor.beginStroke(stroke.settings);
    for (const core::StrokeSample& sample : stroke.samples) {
        dabStart = threadCpuMs();
        sculptor.addSample(sample);
    }
    return sculptor.endStroke();
}

/// What a reset goes back to is the model as it came.
void setStart(Entries& entries, const std::shared_ptr<const core::Snapshot>& start)
{
    for (core::FileEntry& entry : entries) {
        auto* const command = std::get_if<core::FileCommand>(&entry);
        if (auto* const reset = command ? std::get_if<core::Reset>(&command->command) : nullptr)
            reset->start = start;
    }
}

/// `index`: of the entry.
void requireDone(const core::ModelChange& change, const core::FileCommand& entry, std::size_t index)
{
    if (change.refusal != core::ModelRefusal::None)
        throw CommandFailure{ReplayMessages::tr("replay: strokes[%1]: %2")
                                 .arg(index)
                                 .arg(CommandNames::refusal(change, QFile::decodeName(entry.file.c_str()))),
                             AnswerIsNo};
}

/// Does as the Model menu does, by the file's planes and axes.
core::MeshDelta play(core::Sculptor& sculptor, core::StrokeCoordinates& coordinates, const core::FileCommand& entry,
                     std::size_t index)
{
    core::ModelChange change = coordinates.apply(sculptor.mesh(), entry.command);
    requireDone(change, entry, index);
    sculptor.swap(change.delta);
    return std::move(change.delta);
}

struct Replayed
{
    std::vector<ReplayedDab> dabs;
    std::vector<core::MeshDelta> changes; ///< of what changed anything, back to before; only for frames
};

Replayed play(core::Sculptor& sculptor, core::StrokeCoordinates& coordinates, Entries& entries,
              const ReplayOptions& options)
{
    Replayed replayed;
    std::vector<ReplayedDab>& dabs = replayed.dabs;
    const auto addChange = [&](core::MeshDelta change) {
        if (!options.frames.isEmpty() && !change.empty())
            replayed.changes.push_back(std::move(change));
    };
    double dabStart = 0;
    sculptor.setVerification(options.verify != Verify::None);
    if (options.verify == Verify::Full)
        sculptor.setBetweenSubsteps([&] { requireWhole(sculptor, dabs.size()); });
    sculptor.setAfterDab([&](const core::DabReport& report) {
        dabs.push_back({report, threadCpuMs() - dabStart, std::nullopt});
        if (!options.stats.isEmpty() && report.touchedVertices > 0)
            dabs.back().quality = sculptor.selectionQuality();
        dabStart = threadCpuMs();
    });
    takeStrokes(sculptor.mesh(), coordinates, entries, 0, options.strokes);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (const auto* stroke = std::get_if<core::Stroke>(&entries[i])) {
            addChange(play(sculptor, *stroke, dabStart));
            continue;
        }
        addChange(play(sculptor, coordinates, std::get<core::FileCommand>(entries[i]), i));
        takeStrokes(sculptor.mesh(), coordinates, entries, i + 1, options.strokes);
    }
    sculptor.setBetweenSubsteps({});
    sculptor.setAfterDab({});
    return replayed;
}

/// As large as the model is at its start or at its end, so that all is in one view.
void writeFrames(const ReplayOptions& options, const core::Mesh& mesh, std::vector<core::MeshDelta>& changes,
                 const core::Box& box)
{
    const ModelHistory history{
        ModelChangeJob::copyOf(mesh), 0, static_cast<int>(changes.size()),
        [&changes](int index) { return std::optional(std::move(changes[static_cast<std::size_t>(index)])); }};
    const TimeLapseOutcome outcome =
        TimeLapse::run({options.frames, options.every, core::viewOf(box, frameWidth, frameHeight)}, history, {});
    if (!outcome.problem.isEmpty())
        CommandLine::fail(outcome.problem);
}

void run(const ReplayOptions& options, Entries& entries)
{
    readInserted(entries, options.strokes);
    readStrokeAssets(entries, options.strokes);
    // What cannot be written is told before the work, not after it.
    std::optional<core::AtomicFile> stats;
    if (!options.stats.isEmpty())
        stats.emplace(toPath(options.stats));
    if (!options.out.isEmpty())
        core::AtomicFile probe(toPath(options.out));
    if (!options.frames.isEmpty()) {
        const QString obstacle = TimeLapse::obstacle(
            options.frames, TimeLapse::frameNames(0, static_cast<int>(entries.size()), options.every));
        if (!obstacle.isEmpty())
            CommandLine::fail(obstacle);
    }

    const LoadedModel model =
        options.in.isEmpty() ? ModelLoader::sphere(paperRadius) : ModelLoader::loadInPlace(options.in);
    if (!model.sculptor)
        CommandLine::fail(model.problem);
    setStart(entries, model.start);
    core::StrokeCoordinates coordinates(model.metadata.place());
    if (core::ModelChange alignment = coordinates.aligned(model.sculptor->mesh()); alignment.changes)
        model.sculptor->swap(alignment.delta);
    core::Box box = options.frames.isEmpty() ? core::Box() : core::boxOf(core::extractMesh(model.sculptor->mesh()));
    Replayed replayed = play(*model.sculptor, coordinates, entries, options);

    const core::TriangleMesh mesh = core::extractMesh(model.sculptor->mesh());
    if (stats)
        writeReplayStats(*stats, replayed.dabs, *model.sculptor, mesh);
    if (!options.out.isEmpty())
        core::writeMesh(toPath(options.out),
                        core::placedMesh(toPath(options.out), mesh, model.sculptor->mesh().frame().place));
    if (stats)
        stats->commit();
    if (!options.frames.isEmpty())
        writeFrames(options, model.sculptor->mesh(), replayed.changes, box.extend(core::boxOf(mesh)));
}
} // namespace

ExitStatus replayCommand(const QStringList& arguments)
{
    const std::optional<ReplayOptions> options = parseReplayOptions(arguments);
    if (!options)
        return Done;
    requireDifferentFiles(*options);
    if (!options->out.isEmpty())
        CommandLine::requireMeshEnding(options->out);
    std::vector<core::FileEntry> entries = readStrokes(options->strokes);
    try {
        run(*options, entries);
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
    return Done;
}
} // namespace app
