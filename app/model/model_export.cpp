#include "app/model/model_export.h"

#include "app/model/model_loader.h"
#include "app/model/slicer_check.h"

#include "core/io/mesh_io.h"
#include "core/io/placed_mesh.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/decimate.h"
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
} // namespace

ExportOutcome ModelExport::run(ExportRequest request, const OnStage& onStage, const core::JobControl& control)
{
    const bool decimates =
        request.maxTriangles > 0 && request.mesh && request.mesh->live().faces > request.maxTriangles;
    try {
        if (!request.mesh)
            throw std::bad_alloc();
        if (!decimates)
            return write(request, core::extractMesh(*request.mesh), onStage, control);
        onStage(tr("Reducing the triangles"));
        const core::Vec3 place = request.mesh->frame().place;
        core::Decimated few =
            core::decimate(std::move(*request.mesh), request.maxTriangles, control.part(0, afterDecimating));
        if (control.isCancelled())
            return {};
        request.metadata = {}; // they describe the undecimated model
        return write(request, core::placedMesh(toPath(request.path), std::move(few.mesh), place), onStage,
                     control.part(afterDecimating, 1));
    } catch (const core::FileError& error) {
        return {ui::ErrorMessages::sentence(error), {}};
    } catch (const core::ReadingCancelled&) {
        return {{}, tr("Saved %1. It was not verified.").arg(QFileInfo(request.path).fileName())};
    } catch (const std::bad_alloc&) {
        return {tr("%1: there is not enough memory to write this model.").arg(request.path), {}};
    }
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
        const core::ExportVerdict verdict = core::checkExport(toPath(request.path), written, control);
        if (control.isCancelled())
            throw core::ReadingCancelled();
        if (!verdict.sameCorners || !verdict.sameColors)
            return {tr("Saved %1, but reading it back gave something else. The disk may be failing, or another program "
                       "may be changing the file.")
                        .arg(QDir::toNativeSeparators(request.path)),
                    {}};
        if (!verdict.report.printReady())
            return {ui::ErrorMessages::refusal(request.path, verdict.report), {}};
        return {{},
                verdictText(request, verdict.report, !mesh.colors.empty() && !ModelLoader::holdsColors(request.path))};
    } catch (const core::FileError& error) {
        return {ui::ErrorMessages::sentence(error), {}};
    }
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
