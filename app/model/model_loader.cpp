#include "app/model/model_loader.h"

#include "app/import/assimp_import.h"
#include "app/model/repair_doubts.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice_placement.h"
#include "core/io/mesh_io.h"
#include "core/io/numbered_backup.h"
#include "core/io/placed_mesh.h"
#include "core/mesh/mesh_builder.h"
#include "core/parts/part_split.h"
#include "core/repair/repair.h"
#include "core/sculpt/sculptor.h"
#include "ui/model/insert_request.h"
#include "ui/util/error_messages.h"
#include "ui/util/number_format.h"
#include "ui/util/repair_messages.h"

#include <QFileInfo>

#include <new>

namespace app
{
namespace
{
constexpr int paperSubdivisions = 4;
/// afterReading: progress when the file has been read, 0 to 1. afterRepair: share of the remaining progress that is
/// reached when the model has been repaired.
constexpr double afterReading = 0.1, afterRepair = 0.8;
} // namespace

std::filesystem::path toPath(const QString& path)
{
    return std::filesystem::path(path.toStdU16String());
}

LoadedModel ModelLoader::load(const QString& path, const OnStage& onStage, const core::JobControl& control,
                              Objects objects)
{
    const auto process = [](LoadedModel& loaded, const core::TriangleMesh& mesh, const core::JobControl& part) {
        build(loaded, mesh, {.isCentred = true}, part);
        loaded.isRepairable = !loaded.problem.isEmpty();
    };
    LoadedModel loaded = read({path, objects, true}, onStage, control, process);
    if (!loaded.isRepairable || loaded.objects.count == 1)
        return loaded;
    const bool wereParts = loaded.objects.areParts;
    LoadedModel other =
        read({path, wereParts ? Objects::AsOnePart : Objects::AsParts, true}, onStage, control, process);
    if (other.sculptor) {
        other.objects = {}; // there is no choice
        const QString why = wereParts ? tr("The objects of %1 are not solids of their own, so they are one part.")
                                      : tr("The objects of %1 overlap or touch, so each is a part.");
        other.notice = QStringList({why.arg(other.name), other.notice}).join(QLatin1Char(' ')).trimmed();
        return other;
    }
    loaded.problem +=
        u' ' + tr("A repair makes one part of its %Ln objects.", nullptr, static_cast<int>(loaded.objects.count));
    return loaded;
}

LoadedModel ModelLoader::loadRepaired(const QString& path, const core::RepairOptions& options, const OnStage& onStage,
                                      const core::JobControl& control)
{
    return read(
        {path}, onStage, control, [&](LoadedModel& loaded, core::TriangleMesh& mesh, const core::JobControl& part) {
            core::RepairStepCallback onStep;
            if (onStage)
                onStep = [&](core::RepairStep step) { onStage(ui::RepairMessages::progress(loaded.name, step)); };
            core::RepairResult repaired = core::repairMesh(mesh, options, part.part(0, afterRepair), onStep);
            if (!repaired.mesh && !part.isCancelled())
                loaded.problem = ui::RepairMessages::refusal(loaded.path, repaired);
            if (!repaired.mesh)
                return;
            loaded.doubt = repairDoubt(ui::RepairUse::Opening, loaded.name, repaired, mesh);
            mesh = std::move(*repaired.mesh);
            if (loaded.parts.size() > 1)
                loaded.parts = {}; // the repair made one part of all
            loaded.repairs = ui::RepairMessages::steps(repaired.report) + ui::RepairMessages::losses(repaired.report);
            loaded.path.clear();
            if (onStage)
                onStage(tr("Checking %1").arg(loaded.name));
            build(loaded, mesh, {.isCentred = true, .origin = -repaired.report.moved}, part.part(afterRepair, 1));
        });
}

LoadedModel ModelLoader::loadInPlace(const QString& path, Objects objects)
{
    return read({path, objects}, {}, {},
                [](LoadedModel& loaded, const core::TriangleMesh& mesh, const core::JobControl& control) {
                    const core::MeshReport report = build(loaded, mesh, {}, control);
                    if (loaded.sculptor && core::isTooFarForFloats(core::boxOf(mesh), report.area, report.faces)) {
                        loaded.problem = tr("%1 cannot be sculpted where it is: so far from the origin its coordinates "
                                            "are too coarse for its detail.")
                                             .arg(loaded.path);
                        loaded.sculptor.reset();
                    }
                });
}

/// Sets loaded.objects if the user can choose what becomes of the objects; a remark about them is then superfluous.
void ModelLoader::noteObjects(LoadedModel& loaded, const Source& source, core::ReadRemarks& remarks)
{
    const auto format = core::meshFormatOf(toPath(source.path));
    const bool holdsObjects = !format || core::holdsObjects(*format); // files of other formats may have objects
    if (!source.isChoice || !holdsObjects)
        return;
    if (source.objects == Objects::AsParts && loaded.parts.size() > 1 && !loaded.metadata.frame) {
        loaded.objects = {loaded.parts.size(), true};
    } else if (remarks.objects > core::PartList::maxParts) {
        loaded.notice = tr("%1 has more objects than a model may have parts (%Ln), so they are one part.", nullptr,
                           static_cast<int>(core::PartList::maxParts))
                            .arg(loaded.name);
    } else if (source.objects == Objects::AsOnePart && remarks.objects > 1) {
        loaded.objects = {remarks.objects, false};
        remarks.objects = 1;
    }
}

LoadedModel ModelLoader::read(const Source& source, const OnStage& onStage, const core::JobControl& control,
                              const Process& process)
{
    const QString& path = source.path;
    LoadedModel loaded;
    loaded.path = loaded.source = path;
    loaded.name = QFileInfo(path).fileName();
    try {
        auto [mesh, remarks, parts] =
            core::readModel(toPath(path), {.stop = control.stop, .keepsObjects = source.objects == Objects::AsParts});
        loaded.metadata = core::readMetadata(toPath(path));
        loaded.parts = parts;
        noteObjects(loaded, source, remarks);
        if (onStage)
            onStage(tr("Checking %1").arg(loaded.name));
        control.reportProgress(afterReading);
        process(loaded, mesh, control.part(afterReading, 1));
        if (loaded.sculptor)
            loaded.notice = QStringList({ui::ErrorMessages::remarks(loaded.name, remarks), loaded.notice})
                                .join(QLatin1Char(' '))
                                .trimmed();
    } catch (const core::ReadingCancelled&) {
        return {};
    } catch (const core::FileError& error) {
        loaded.problem = ui::ErrorMessages::sentence(error);
    } catch (const std::bad_alloc&) {
        loaded.problem = tr("%1: there is not enough memory for this model.").arg(path);
    }
    return loaded;
}

core::MeshReport ModelLoader::build(LoadedModel& loaded, const core::TriangleMesh& mesh, const Placing& placing,
                                    const core::JobControl& control)
{
    core::BuildResult result = core::buildMesh(mesh, placing.isCentred, control, loaded.metadata.frame);
    if (control.isCancelled())
        return {};
    if (!result.mesh && !result.report.printReady())
        loaded.problem = ui::ErrorMessages::refusal(loaded.path, result.report);
    else if (!result.mesh)
        loaded.problem = ui::ErrorMessages::tooFine(loaded.path, result.unsnappable);
    if (!result.mesh)
        return result.report;
    core::MeshFrame frame = result.mesh->frame();
    frame.place += placing.origin;
    frame.parts = core::listedParts(mesh, loaded.parts);
    result.mesh->beginStroke();
    result.mesh->setFrame(frame);
    result.mesh->endStroke();
    loaded.start = core::snapshotOf(*result.mesh);
    loaded.sculptor = std::make_shared<core::Sculptor>(std::move(result.mesh));
    if (placing.isCentred && !holdsUnit(loaded.name))
        loaded.unitGuess = core::guessedUnit(*result.report.volume, result.report.size.maxCoeff());
    return result.report;
}

QString ModelLoader::insertedUnitNotice(const ui::InsertRequest& insertion, double volume)
{
    if (insertion.unit != 1 || holdsUnit(insertion.path) || core::unitDoubtOf(volume) == core::UnitDoubt::None)
        return {};
    return tr("%1 is very small in millimetres (%2). If it was made in another unit, undo, and say which when you "
              "insert it again.")
        .arg(QFileInfo(insertion.path).fileName(), ui::volumeText(volume));
}

bool ModelLoader::holdsUnit(const QString& path)
{
    const auto format = core::meshFormatOf(toPath(path));
    if (!format)
        return assimpHoldsUnit(toPath(path));
    return format == core::MeshFormat::Glb || format == core::MeshFormat::Gltf || format == core::MeshFormat::ThreeMf ||
           format == core::MeshFormat::Amf;
}

LoadedModel ModelLoader::sphere(double radius)
{
    LoadedModel loaded;
    loaded.name = tr("Ball of clay");
    loaded.metadata.work.emplace(); // a new model: its work counters start at zero
    build(loaded, core::icosphere(paperSubdivisions, radius), {}, {});
    return loaded;
}

LoadedModel ModelLoader::starter(core::Starter starter)
{
    LoadedModel loaded;
    loaded.name = name(starter);
    loaded.metadata.work.emplace(); // a new model: its work counters start at zero
    build(loaded, core::starterModel(starter), {}, {});
    return loaded;
}

QString ModelLoader::name(core::Starter starter)
{
    const QString names[] = {tr("Ball"), tr("Cube"), tr("Torus"), tr("Slab"), tr("Vase"), tr("Head"), tr("Tablet")};
    static_assert(std::size(names) == static_cast<std::size_t>(core::Starter::Tablet) + 1);
    return names[static_cast<std::size_t>(starter)];
}

bool ModelLoader::holdsColors(const QString& path)
{
    const auto format = core::meshFormatOf(toPath(path));
    return format && core::holdsColors(*format);
}

core::TriangleMesh ModelLoader::writtenSurface(const QString& path, const core::TriangleMesh& mesh,
                                               const core::DocumentMetadata& metadata)
{
    const auto format = core::meshFormatOf(toPath(path));
    const bool isWhole = !metadata.frame || (format && core::holdsHiddenParts(*format));
    return isWhole ? mesh : core::visibleParts(mesh, metadata.frame->parts);
}

QString ModelLoader::save(const QString& path, const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata,
                          int backupCount)
{
    try {
        core::TriangleMesh surface = writtenSurface(path, mesh, metadata);
        if (surface.triangles.empty())
            return tr("%1 was not written, because all parts are hidden. GLB keeps hidden parts.").arg(path);
        core::NumberedBackup before(toPath(path), backupCount);
        core::writeMesh(toPath(path), core::placedMesh(toPath(path), std::move(surface), metadata.place()),
                        {.metadata = metadata});
        before.commit();
    } catch (const core::FileError& error) {
        return ui::ErrorMessages::sentence(error);
    } catch (const std::bad_alloc&) {
        return tr("%1: there is not enough memory to write this model.").arg(path);
    }
    return {};
}
} // namespace app
