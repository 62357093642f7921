// replay: plays strokes and commands from a file on a model, or on the paper's sphere, and writes the results. First it
// checks all input, then sculpts, then writes. Strokes after a command are checked when that command is done. Nothing
// is written if there is an error.
#include "app/commands/command_line.h"
#include "app/commands/command_models.h"
#include "app/commands/replay_stats.h"
#include "app/commands/standard_files.h"
#include "app/commands/stroke_assets.h"
#include "app/document/time_lapse.h"
#include "app/model/command_names.h"
#include "app/model/model_change_job.h"
#include "app/model/model_loader.h"

#include "core/analysis/mesh_check.h"
#include "core/geometry/face_geometry.h"
#include "core/io/mesh_io.h"
#include "core/io/stroke/stroke_file.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/part_operations.h"
#include "core/operations/stroke_coordinates.h"
#include "core/util/system_path.h"
#include "core/util/thread_cpu_time.h"
#include "ui/util/error_messages.h"
#include "ui/util/number_format.h"
#include "ui/util/stroke_file_messages.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <utility>

namespace app
{
namespace
{
constexpr double paperRadius = 1;
constexpr int frameWidth = 1280, frameHeight = 720;
constexpr unsigned maxEvery = 1000000; ///< largest value of --every; larger values are clamped to it

class ReplayMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::ReplayCommand)
};

/// The ways to verify the result of each dab. None skips verification; it is for measurements only, so --out is
/// refused.
enum class Verify { Local, Full, None };

struct ReplayOptions
{
    QString strokes, in, out, stats;
    QString frames; ///< folder for pictures; empty: none
    int every = 1;
    Verify verify = Verify::Local;
    bool keepsObjects = false; ///< makes a part of each object of `in`
};

/// Fails if two options name the same file: the strokes or the model would be overwritten.
void requireDifferentFiles(const ReplayOptions& options)
{
    struct Use
    {
        QString option, file;
        bool isRead;
    };
    const Use files[] = {{QStringLiteral("--strokes"), options.strokes, true},
                         {QStringLiteral("--in"), options.in, true},
                         {QStringLiteral("--out"), options.out, false},
                         {QStringLiteral("--stats"), options.stats, false}};
    std::map<std::filesystem::path, QString> seen;
    for (const auto& [option, file, isRead] : files) {
        if (file.isEmpty())
            continue;
        std::error_code problem; // if it is set, the path is empty; the error is reported when the file is used
        const std::filesystem::path path = StandardFiles::isStandard(file)
                                               ? std::filesystem::path(isRead ? "-, read" : "-, written")
                                               : std::filesystem::weakly_canonical(toPath(file), problem);
        const auto [other, isNew] = seen.emplace(path, option);
        if (!isNew && !path.empty())
            CommandLine::fail(
                ReplayMessages::tr("replay: %1 and %2 name the same file, %3.").arg(other->second, option, file));
    }
}

std::optional<ReplayOptions> parseReplayOptions(const QStringList& arguments)
{
    const QString strokes = QStringLiteral("strokes"), in = QStringLiteral("in"), out = QStringLiteral("out"),
                  stats = QStringLiteral("stats"), frames = QStringLiteral("frames"), every = QStringLiteral("every"),
                  verify = QStringLiteral("verify"), parts = QStringLiteral("parts");
    const QStringList verifications{QStringLiteral("local"), QStringLiteral("full"), QStringLiteral("none")};
    QCommandLineParser parser;
    parser.setApplicationDescription(
        ReplayMessages::tr("Plays recorded strokes on a model, or on the paper's sphere."));
    parser.addOptions(
        {{strokes, ReplayMessages::tr("The strokes, JSON; or -."), QStringLiteral("S.json")},
         {in, ReplayMessages::tr("The model; or - (default: a sphere of 2562 vertices, radius 1)."),
          QStringLiteral("FILE")},
         {parts, ReplayMessages::tr("Make a part of each object of the model; parts may overlap.")},
         {{QStringLiteral("o"), out}, ReplayMessages::tr("File for the sculpted model; or -."), QStringLiteral("FILE")},
         {stats, ReplayMessages::tr("File for cost and outcome of each dab, JSON; or -."), QStringLiteral("T.json")},
         {frames, ReplayMessages::tr("Folder for pictures of the model, PNG, at the start and after each stroke."),
          QStringLiteral("FOLDER")},
         {every, ReplayMessages::tr("Strokes from one picture to the next (default: 1)."), QStringLiteral("N")},
         {verify,
          ReplayMessages::tr("local: what changed (as in the window, the default); full: the whole mesh after each dab "
                             "as well; none: for measurements, without --out."),
          verifications.join(u'|')}});
    StandardFiles::addFrom(parser);
    StandardFiles::addTo(parser);
    CommandOptions::addNoClobber(parser);
    const CommandOptions given(parser, QStringLiteral("replay"), arguments);
    if (given.isAnswered())
        return std::nullopt;
    ReplayOptions options{given.text(strokes),
                          given.text(in),
                          given.text(out),
                          given.text(stats),
                          given.text(frames),
                          static_cast<int>(std::min(given.wholeNumber(every, 1), maxEvery)),
                          static_cast<Verify>(given.choice(verify, verifications)),
                          given.has(parts)};
    if (!given.files().isEmpty())
        CommandLine::fail(
            ReplayMessages::tr("replay: %1 is not an option; give the model with --in.").arg(given.files().first()));
    if (options.strokes.isEmpty())
        CommandLine::fail(ReplayMessages::tr("replay: --strokes is missing."));
    given.requireWith({every}, frames);
    given.requireWith({parts}, in);
    if (options.verify == Verify::None && given.has(out))
        CommandLine::fail(ReplayMessages::tr("replay: --verify none and --out cannot be used together: what is not "
                                             "verified is not kept."));
    requireDifferentFiles(options);
    given.requireFree(options.out);
    given.requireFree(options.stats);
    options.out = StandardFiles::output(given, options.out);
    options.stats = StandardFiles::output(given, options.stats, {QStringLiteral("json")});
    if (!options.out.isEmpty())
        CommandLine::requireMeshEnding(options.out);
    options.in = StandardFiles::input(given, options.in);
    return options;
}

std::vector<core::FileEntry> readStrokes(const QString& path)
{
    try {
        return StandardFiles::isStandard(path) ? core::readStrokes(std::cin) : core::readStrokes(toPath(path));
    } catch (const core::StrokeFileError& error) {
        throw CommandFailure{ui::StrokeFileMessages::sentence(path, error)};
    }
}

using Entries = std::vector<core::FileEntry>;

/// Reads the models to be inserted. Relative paths are resolved against the stroke file.
void readInserted(Entries& entries, const QString& strokes)
{
    for (std::size_t i = 0; i < entries.size(); ++i) {
        auto* const command = std::get_if<core::FileCommand>(&entries[i]);
        auto* const insertion = command ? std::get_if<core::Insert>(&command->command) : nullptr;
        if (!insertion || insertion->primitive)
            continue;
        try {
            insertion->model = core::readMesh(toPath(strokes).parent_path() / core::pathOfUtf8(command->file));
            insertion->model.parts.clear(); // it becomes one part
            if (insertion->name.empty())
                insertion->name = core::shortened(core::pathOfUtf8(command->file).stem().string());
        } catch (const core::FileError& error) {
            core::StrokeFileError place(core::StrokeFileError::Kind::CannotRead);
            place.stroke = i;
            CommandLine::fail(
                ReplayMessages::tr("%1: %2: %3", "file: place: reason")
                    .arg(strokes, ui::StrokeFileMessages::place(place), ui::ErrorMessages::sentence(error)));
        }
    }
}

/// Converts the strokes from `first` up to the next command to the document's coordinates. Called again after each
/// command, because it may have changed the model's position and lattice. Throws CommandFailure if a stroke does not
/// fit the model.
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

/// Fails if the mesh is not sound. `dab`: index of the present dab, from 0.
void requireWhole(const core::Sculptor& sculptor, std::size_t dab)
{
    if (!core::checkMesh(core::extractMesh(sculptor.mesh())).printReady())
        throw CommandFailure{ReplayMessages::tr("replay: the mesh is not valid after dab %1.").arg(dab), AnswerIsNo};
}

core::MeshDelta play(core::Sculptor& sculptor, const core::Stroke& stroke, double& dabStart)
{
    sculptor.beginStroke(stroke.settings);
    for (const core::StrokeSample& sample : stroke.samples) {
        dabStart = core::threadCpuMs();
        sculptor.addSample(sample);
    }
    return sculptor.endStroke();
}

/// Sets the start of all Reset commands: the model as it was opened, which they restore.
void setStart(Entries& entries, const std::shared_ptr<const core::Snapshot>& start)
{
    for (core::FileEntry& entry : entries) {
        auto* const command = std::get_if<core::FileCommand>(&entry);
        if (auto* const reset = command ? std::get_if<core::Reset>(&command->command) : nullptr)
            reset->start = start;
    }
}

/// Fails if the command was refused. `index`: index of the entry in the stroke file.
void requireDone(const core::ModelChange& change, const core::FileCommand& entry, std::size_t index)
{
    if (change.refusal != core::ModelRefusal::None)
        throw CommandFailure{ReplayMessages::tr("replay: strokes[%1]: %2")
                                 .arg(index)
                                 .arg(CommandNames::refusal(change, QString::fromStdString(entry.file))),
                             AnswerIsNo};
}

/// Fails if the part of a stroke is missing, hidden or locked: the stroke would change nothing.
void requireEditable(const core::Mesh& mesh, core::PartId part, std::size_t index)
{
    core::ModelChange change;
    change.refusal = core::refusalOf(mesh, part);
    requireDone(change, {}, index);
}

/// Applies a command as the Model menu does, with planes and axes in the file's coordinates.
core::MeshDelta play(core::Sculptor& sculptor, core::StrokeCoordinates& coordinates, const core::FileCommand& entry,
                     std::size_t index)
{
    core::ModelChange change = coordinates.apply(sculptor.mesh(), entry.command, entry.part);
    requireDone(change, entry, index);
    sculptor.swap(change.delta);
    return std::move(change.delta);
}

struct Replayed
{
    std::vector<ReplayedDab> dabs;
    std::vector<core::MeshDelta> changes; ///< deltas that undo each change; only filled if frames are written
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
        dabs.push_back({report, core::threadCpuMs() - dabStart, std::nullopt});
        if (!options.stats.isEmpty() && report.touchedVertices > 0)
            dabs.back().quality = sculptor.selectionQuality();
        dabStart = core::threadCpuMs();
    });
    takeStrokes(sculptor.mesh(), coordinates, entries, 0, options.strokes);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (const auto* stroke = std::get_if<core::Stroke>(&entries[i])) {
            requireEditable(sculptor.mesh(), stroke->settings.part, i);
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

/// Writes the frames, with a view that contains the model at its start and at its end.
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

/// Returns one line about the result. The time is the sum of the dabs' times.
QString summary(const Entries& entries, const std::vector<ReplayedDab>& dabs, const core::TriangleMesh& mesh)
{
    const auto strokes = std::ranges::count_if(
        entries, [](const core::FileEntry& entry) { return std::holds_alternative<core::Stroke>(entry); });
    double seconds = 0;
    for (const ReplayedDab& dab : dabs)
        seconds += dab.report.totalMs / 1000;
    const core::Vec3 size = core::boxOf(mesh).sizes();
    return ReplayMessages::tr("Strokes: %1, commands: %2, dabs: %3. Size: %4 x %5 x %6 mm, triangles: %7. Time: %8 s.")
               .arg(strokes)
               .arg(std::ssize(entries) - strokes)
               .arg(dabs.size())
               .arg(ui::millimetres(size.x()), ui::millimetres(size.y()), ui::millimetres(size.z()))
               .arg(mesh.triangles.size())
               .arg(QString::number(seconds, 'f', 1)) +
           u'\n';
}

/// Writes the visible parts, or all to a format that keeps them hidden, as Save does.
void writeModel(const QString& out, const core::TriangleMesh& whole, const core::MeshFrame& frame)
{
    core::DocumentMetadata metadata;
    metadata.frame = frame;
    core::TriangleMesh mesh = ModelLoader::writtenSurface(out, whole, metadata);
    using core::PartUnion;
    switch (unitePartsFor(out, mesh)) {
    case PartUnion::NotNeeded:
        break;
    case PartUnion::Done:
        metadata.frame->parts = {};
        CommandLine::printRemark(ReplayMessages::tr("The parts overlap, so they were united.") + u'\n');
        break;
    case PartUnion::Failed:
        CommandLine::fail(
            ReplayMessages::tr("%1: the parts overlap and cannot be united. A GLB file keeps them apart.").arg(out));
    }
    if (const QString problem = ModelLoader::save(out, mesh, metadata); !problem.isEmpty())
        CommandLine::fail(problem);
}

/// Reads the model to be sculpted, or fails.
LoadedModel loadStart(const ReplayOptions& options)
{
    using Objects = ModelLoader::Objects;
    if (options.in.isEmpty())
        return ModelLoader::sphere(paperRadius);
    LoadedModel model =
        ModelLoader::loadInPlace(options.in, options.keepsObjects ? Objects::AsParts : Objects::AsOnePart);
    if (model.sculptor)
        return model;
    if (!options.keepsObjects) {
        const LoadedModel other = ModelLoader::loadInPlace(options.in, Objects::AsParts);
        if (other.sculptor && other.parts.size() > 1)
            model.problem += u' ' + ReplayMessages::tr("--parts keeps its objects apart, which may overlap then.");
    }
    CommandLine::fail(model.problem);
}

void run(const ReplayOptions& options, Entries& entries)
{
    readInserted(entries, options.strokes);
    readStrokeAssets(entries, options.strokes);
    // Errors in output files are reported before the work, not after it.
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

    const LoadedModel model = loadStart(options);
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
        writeModel(options.out, mesh, model.sculptor->mesh().frame());
    if (stats)
        stats->commit();
    if (!options.frames.isEmpty())
        writeFrames(options, model.sculptor->mesh(), replayed.changes, box.extend(core::boxOf(mesh)));
    if (!StandardFiles::hasOutput())
        CommandLine::print(summary(entries, replayed.dabs, mesh));
    StandardFiles::flush();
}
} // namespace

ExitStatus replayCommand(const QStringList& arguments)
{
    const std::optional<ReplayOptions> options = parseReplayOptions(arguments);
    if (!options)
        return Done;
    std::vector<core::FileEntry> entries = readStrokes(options->strokes);
    try {
        run(*options, entries);
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
    return Done;
}
} // namespace app
