#include "app/model/model_export.h"

#include "app/model/model_loader.h"
#include "app/model/slicer_check.h"

#include "core/analysis/part_overlap.h"
#include "core/decimation/decimate.h"
#include "core/io/mesh_io.h"
#include "core/io/placed_mesh.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/part_union.h"
#include "ui/util/error_messages.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <new>

namespace app
{
namespace
{
/// afterDecimating: progress when the model is decimated, 0 to 1. afterWriting: share of the remaining progress that is
/// reached when the file is written.
constexpr double afterDecimating = 0.85, afterWriting = 0.2;

/// Returns whether the file has one surface, in which parts that overlap would intersect.
bool holdsOneSurface(const QString& path)
{
    const auto format = core::meshFormatOf(toPath(path));
    return format && !core::holdsObjects(*format);
}
} // namespace

bool ModelExport::joinsPartsByDefault(const QString& path)
{
    return holdsOneSurface(path) || core::meshFormatOf(toPath(path)) == core::MeshFormat::ThreeMf;
}

ExportOutcome ModelExport::run(ExportRequest request, const OnStage& onStage, const core::JobControl& control)
{
    try {
        if (!request.mesh)
            throw std::bad_alloc();
        core::TriangleMesh mesh =
            ModelLoader::writtenSurface(request.path, core::extractMesh(*request.mesh), request.metadata);
        const bool hasParts = !mesh.parts.empty();
        if (const QString problem = join(request, mesh, onStage, control); !problem.isEmpty())
            return {problem, {}};
        if (hasParts && control.isCancelled())
            return {};
        if (request.maxTriangles == 0 || mesh.triangles.size() <= request.maxTriangles)
            return write(request, mesh, onStage, control);
        onStage(tr("Reducing the triangles"));
        decimate(request, mesh, control.part(0, afterDecimating));
        if (control.isCancelled())
            return {};
        return write(request, mesh, onStage, control.part(afterDecimating, 1));
    } catch (const core::FileError& error) {
        return {ui::ErrorMessages::sentence(error), {}};
    } catch (const core::ReadingCancelled&) {
        return {{}, tr("Saved %1. It was not verified.").arg(QFileInfo(request.path).fileName())};
    } catch (const std::bad_alloc&) {
        return {tr("%1: there is not enough memory to write this model.").arg(request.path), {}};
    }
}

/// Unites the parts if this is requested and they overlap. Returns an empty string, or one sentence why this is not
/// possible.
QString ModelExport::join(ExportRequest& request, core::TriangleMesh& mesh, const OnStage& onStage,
                          const core::JobControl& control)
{
    if (!request.joinsParts || !joinsPartsByDefault(request.path) || !request.metadata.frame || mesh.parts.empty())
        return {};
    onStage(tr("Joining the parts"));
    const core::PartUnion done = core::uniteParts(mesh, request.mesh->lattice(), control.part(0, 0));
    if (done == core::PartUnion::Done)
        request.metadata.frame->parts = {};
    if (done != core::PartUnion::Failed || control.isCancelled())
        return {};
    return tr("%1 was not written: its parts overlap and cannot be joined. Move one a little, or export them one by "
              "one.")
        .arg(QDir::toNativeSeparators(request.path));
}

/// Decimates each part by the same share. Metadata describe the undecimated model; only the list of parts is kept.
void ModelExport::decimate(ExportRequest& request, core::TriangleMesh& mesh, const core::JobControl& control)
{
    core::MeshFrame frame = request.mesh->frame();
    if (frame.parts.size() == 1) {
        request.metadata = {};
        mesh = core::decimate(std::move(*request.mesh), request.maxTriangles, control).mesh;
        if (!control.isCancelled())
            mesh = core::placedMesh(toPath(request.path), std::move(mesh), frame.place);
        return;
    }
    frame.parts = request.metadata.frame ? request.metadata.frame->parts : core::PartList();
    request.metadata = {};
    request.metadata.frame = frame;
    mesh = core::decimateEachPart(mesh, frame.lattice, request.maxTriangles, control);
}

ExportOutcome ModelExport::write(const ExportRequest& request, const core::TriangleMesh& mesh, const OnStage& onStage,
                                 const core::JobControl& control)
{
    onStage(tr("Exporting %1").arg(QFileInfo(request.path).fileName()));
    const QString problem = ModelLoader::save(request.path, mesh, request.metadata);
    if (!problem.isEmpty())
        return {problem, {}};
    control.reportProgress(afterWriting);
    onStage(tr("Reading %1 back").arg(QFileInfo(request.path).fileName()));
    ExportOutcome outcome = readBack(request, mesh, control.part(afterWriting, 1));
    if (!request.slices || outcome.verdict.isEmpty())
        return outcome;
    onStage(tr("Slicing %1").arg(QFileInfo(request.path).fileName()));
    outcome.verdict += u' ' + SlicerCheck::run(request.path, control);
    return outcome;
}

ExportOutcome ModelExport::readBack(const ExportRequest& request, const core::TriangleMesh& mesh,
                                    const core::JobControl& control)
{
    try {
        const core::TriangleMesh written = core::placedMesh(toPath(request.path), mesh, request.metadata.place());
        const core::ExportVerdict verdict =
            core::checkExport(toPath(request.path), written, control,
                              request.metadata.frame ? request.metadata.frame->parts : core::PartList());
        if (control.isCancelled())
            throw core::ReadingCancelled();
        if (!verdict.sameCorners || !verdict.sameColors)
            return {tr("Saved %1, but reading it back gave something else. The disk may be failing, or another program "
                       "may be changing the file.")
                        .arg(QDir::toNativeSeparators(request.path)),
                    {}};
        const bool areApart =
            !request.joinsParts && holdsOneSurface(request.path) && core::doPartsOverlap(written, control.part(1, 1));
        // surfaces of different parts may intersect then, but each part must still be sound
        const core::MeshReport report = areApart ? core::checkMesh(written, control.part(1, 1)) : verdict.report;
        if (control.isCancelled())
            throw core::ReadingCancelled();
        if (!report.printReady())
            return {ui::ErrorMessages::refusal(request.path, report), {}};
        if (areApart)
            return {{}, apartText(request.path)};
        return {{}, verdictText(request, report, !mesh.colors.empty() && !ModelLoader::holdsColors(request.path))};
    } catch (const core::FileError& error) {
        return {ui::ErrorMessages::sentence(error), {}};
    }
}

QString ModelExport::apartText(const QString& path)
{
    return tr("%1 was written with parts that overlap, as you wished: their surfaces intersect.")
        .arg(QFileInfo(path).fileName());
}

QString ModelExport::verdictText(const ExportRequest& request, const core::MeshReport& report, bool losesColors)
{
    const QLocale locale;
    const auto side = [&](int axis) { return locale.toString(report.size[axis], 'f', 1); };
    QString line = tr("%1: %2 × %3 × %4 mm, %5 triangles; verified, watertight.")
                       .arg(QFileInfo(request.path).fileName(), side(0), side(1), side(2),
                            locale.toString(static_cast<qulonglong>(report.faces)));
    if (losesColors)
        line += u' ' + tr("Its format has no colours; GLB and 3MF keep them.");
    if (request.maxTriangles > 0 && report.faces > request.maxTriangles)
        line += u' ' + tr("%1 triangles were asked for; this could not be reached without losing handles or parts, or "
                          "flipping faces.")
                           .arg(locale.toString(static_cast<qulonglong>(request.maxTriangles)));
    const QString doubt = ui::ErrorMessages::unitDoubt(report.volume.value_or(0));
    return doubt.isEmpty() ? line : line + u' ' + doubt;
}
} // namespace app
