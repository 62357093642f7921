#include "app/model/model_export.h"

#include "app/model/model_loader.h"
#include "app/model/slicer_check.h"

#include "core/io/mesh_io.h"
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
/// Shares of the time.
constexpr double afterDecimating = 0.85, afterWriting = 0.2;
} // namespace

ExportOutcome ModelExport::run(ExportOrder order, const Tell& tell, const core::JobControl& control)
{
    const bool decimates = order.mostTriangles > 0 && order.mesh && order.mesh->live().faces > order.mostTriangles;
    try {
        if (!order.mesh)
            throw std::bad_alloc();
        if (!decimates)
            return write(order, core::extractMesh(*order.mesh), tell, control);
        tell(tr("Reducing the triangles"));
        const core::Decimated few =
            core::decimate(std::move(*order.mesh), order.mostTriangles, control.part(0, afterDecimating));
        if (control.isCancelled())
            return {};
        order.metadata = {}; // they are of the whole model
        return write(order, few.mesh, tell, control.part(afterDecimating, 1));
    } catch (const core::ReadingCancelled&) {
        return {{}, tr("%1 was written; it was not read back.").arg(QDir::toNativeSeparators(order.path))};
    } catch (const std::bad_alloc&) {
        return {tr("%1: there is not enough memory to write this model.").arg(order.path), {}};
    }
}

ExportOutcome ModelExport::write(const ExportOrder& order, const core::TriangleMesh& mesh, const Tell& tell,
                                 const core::JobControl& control)
{
    tell(tr("Exporting %1").arg(QFileInfo(order.path).fileName()));
    const QString problem = ModelLoader::save(order.path, mesh, order.metadata);
    if (!problem.isEmpty())
        return {problem, {}};
    control.reportProgress(afterWriting);
    tell(tr("Reading %1 back").arg(QFileInfo(order.path).fileName()));
    ExportOutcome outcome = judge(order, mesh, control.part(afterWriting, 1));
    if (!order.slices || outcome.verdict.isEmpty())
        return outcome;
    tell(tr("Slicing %1").arg(QFileInfo(order.path).fileName()));
    outcome.verdict += u' ' + SlicerTrial::run(order.path, control);
    return outcome;
}

ExportOutcome ModelExport::judge(const ExportOrder& order, const core::TriangleMesh& mesh,
                                 const core::JobControl& control)
{
    try {
        const core::ExportVerdict verdict = core::checkExport(toPath(order.path), mesh, control);
        if (control.isCancelled())
            throw core::ReadingCancelled();
        if (!verdict.sameCorners || !verdict.sameColors)
            return {tr("%1 was written, but it does not hold what was written. The disk may be failing, or another "
                       "program changes the file.")
                        .arg(QDir::toNativeSeparators(order.path)),
                    {}};
        if (!verdict.report.printReady())
            return {ui::ErrorMessages::refusal(order.path, verdict.report), {}};
        return {{}, word(order, verdict.report, !mesh.colors.empty() && !ModelLoader::holdsColors(order.path))};
    } catch (const core::FileError& error) {
        return {ui::ErrorMessages::sentence(error), {}};
    }
}

QString ModelExport::word(const ExportOrder& order, const core::MeshReport& report, bool losesColors)
{
    const QLocale locale;
    const auto side = [&](int axis) { return locale.toString(report.size[axis], 'f', 1); };
    QString line = tr("%1: %2 × %3 × %4 mm, %5 triangles; read back bit for bit, in fine fettle.")
                       .arg(QDir::toNativeSeparators(order.path), side(0), side(1), side(2),
                            locale.toString(static_cast<qulonglong>(report.faces)));
    if (losesColors)
        line += u' ' + tr("Its format does not hold the colours; GLB and 3MF do.");
    if (order.mostTriangles > 0 && report.faces > order.mostTriangles)
        line += u' ' + tr("With fewer triangles its handles and parts could not all stay.");
    const QString doubt = ui::ErrorMessages::unitDoubt(report.volume.value_or(0));
    return doubt.isEmpty() ? line : line + u' ' + doubt;
}
} // namespace app
