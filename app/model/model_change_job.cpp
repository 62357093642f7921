#include "app/model/model_change_job.h"

#include "app/model/command_names.h"
#include "app/model/model_loader.h"
#include "app/model/repair_doubts.h"

#include "core/geometry/scale_mesh.h"
#include "core/io/mesh_io.h"
#include "core/io/placed_mesh.h"
#include "core/mesh/mesh.h"
#include "ui/util/error_messages.h"
#include "ui/util/repair_messages.h"

#include <QFileInfo>

#include <new>

namespace app
{
namespace
{
/// progress when the inserted model is ready, 0 to 1: without a repair, and with one
constexpr double afterInsertReading = 0.2, afterInsertRepair = 0.8;
} // namespace

std::shared_ptr<core::Mesh> ModelChangeJob::copyOf(const core::Mesh& mesh)
{
    try {
        return std::make_shared<core::Mesh>(mesh);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

ModelChangeOutcome ModelChangeJob::run(const std::shared_ptr<core::Mesh>& copy, ModelChangeRequest request,
                                       const OnStage& onStage, const core::JobControl& control)
{
    ModelChangeOutcome outcome;
    core::JobControl changeControl = control;
    try {
        if (!copy)
            throw std::bad_alloc();
        const auto* insertion = std::get_if<core::Insert>(&request.command);
        const bool hasFile = insertion && !insertion->primitive;
        if (hasFile) {
            const double share = request.insertion.repair ? afterInsertRepair : afterInsertReading;
            read(outcome, request, onStage, control.part(0, share));
            changeControl = control.part(share, 1);
        }
        if (!outcome.problem.isEmpty() || outcome.doubt || control.isCancelled())
            return outcome;
        outcome.change = core::applyToCopy(std::move(*copy), request.command, changeControl, request.part);
        outcome.problem = CommandNames::refusal(outcome.change, request.insertion.path);
        if (hasFile && outcome.change.changes && outcome.change.report.volume)
            outcome.notice =
                QStringList(
                    {outcome.notice, ModelLoader::insertedUnitNotice(request.insertion, *outcome.change.report.volume)})
                    .join(u' ')
                    .trimmed();
        outcome.isRepairable = outcome.change.refusal == core::ModelRefusal::Unsound;
    } catch (const core::ReadingCancelled&) {
    } catch (const core::FileError& error) {
        outcome.problem = ui::ErrorMessages::sentence(error);
    } catch (const std::bad_alloc&) {
        outcome.problem = tr("There is not enough memory for this; the model stays as it is.");
    }
    return outcome;
}

/// Reads the model to insert, and repairs it if requested. A repair moves the model to the origin; this moves it back
/// to the place that its file gives it.
void ModelChangeJob::read(ModelChangeOutcome& outcome, ModelChangeRequest& request, const OnStage& onStage,
                          const core::JobControl& control)
{
    const ui::InsertRequest& insertion = request.insertion;
    core::ReadResult read = core::readModel(toPath(insertion.path), {.stop = control.stop});
    core::TriangleMesh& mesh = read.mesh;
    mesh.parts.clear(); // it becomes one part
    const QString name = QFileInfo(insertion.path).fileName();
    outcome.notice = ui::ErrorMessages::remarks(name, read.remarks);
    if (!core::scaleMesh(mesh, insertion.unit)) {
        outcome.problem = ui::ErrorMessages::tooLarge(insertion.path);
        return;
    }
    if (insertion.repair) {
        const auto onStep = [&](core::RepairStep step) { onStage(ui::RepairMessages::progress(name, step)); };
        core::RepairResult repaired = core::repairMesh(mesh, *insertion.repair, control, onStep);
        if (!repaired.mesh && !control.isCancelled())
            outcome.problem = ui::RepairMessages::refusal(insertion.path, repaired);
        if (!repaired.mesh)
            return;
        if (!insertion.acceptsLoss)
            outcome.doubt = repairDoubt(ui::RepairUse::Insertion, name, repaired, mesh);
        if (outcome.doubt)
            return;
        mesh = core::placedMesh(toPath(insertion.path), std::move(*repaired.mesh), -repaired.report.moved);
        outcome.repairs = ui::RepairMessages::steps(repaired.report) + ui::RepairMessages::losses(repaired.report);
        onStage(CommandNames::progress(request.command));
    }
    std::get<core::Insert>(request.command).model = std::move(mesh);
}
} // namespace app
