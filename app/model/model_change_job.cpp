#include "app/model/model_change_job.h"

#include "app/model/command_names.h"
#include "app/model/model_loader.h"

#include "core/geometry/scale_mesh.h"
#include "core/io/mesh_io.h"
#include "ui/util/error_messages.h"
#include "ui/util/repair_messages.h"

#include <QFileInfo>

#include <new>

namespace app
{
namespace
{
constexpr double afterTrialReading = 0.2, afterTrialMending = 0.8; ///< shares of the time
}

std::shared_ptr<core::Mesh> ModelTrial::copyOf(const core::Mesh& mesh)
{
    try {
        return std::make_shared<core::Mesh>(mesh);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

ModelOutcome ModelTrial::run(const std::shared_ptr<core::Mesh>& copy, core::ModelCommand& command,
                             const ui::InsertRequest& insertion, const Tell& tell, const core::JobControl& control)
{
    ModelOutcome outcome;
    core::JobControl trial = control;
    try {
        if (!copy)
            throw std::bad_alloc();
        if (auto* insert = std::get_if<core::Insert>(&command)) {
            const double share = insertion.repair ? afterTrialMending : afterTrialReading;
            read(outcome, *insert, insertion, tell, control.part(0, share));
            trial = control.part(share, 1);
        }
        if (!outcome.problem.isEmpty() || control.isCancelled())
            return outcome;
        outcome.change = core::applyToCopy(std::move(*copy), command, trial);
        outcome.problem = ModelWords::refusal(outcome.change, insertion.path);
        if (outcome.change.changes && outcome.change.report.volume)
            outcome.notice =
                QStringList({outcome.notice, ModelLoader::insertedUnitNotice(insertion, *outcome.change.report.volume)})
                    .join(u' ')
                    .trimmed();
        outcome.isMendable = outcome.change.refusal == core::ModelRefusal::Unsound;
    } catch (const core::ReadingCancelled&) {
    } catch (const core::FileError& error) {
        outcome.problem = ui::ErrorMessages::sentence(error);
    } catch (const std::bad_alloc&) {
        outcome.problem = tr("There is not enough memory for that; the model stays as it is.");
    }
    return outcome;
}

/// Mended or not, it comes as its file has it: a model that lay far from the origin goes back there.
void ModelTrial::read(ModelOutcome& outcome, core::Insert& command, const ui::InsertRequest& insertion,
                      const Tell& tell, const core::JobControl& control)
{
    auto [mesh, remarks] = core::readModel(toPath(insertion.path), {.stop = control.stop});
    const QString name = QFileInfo(insertion.path).fileName();
    outcome.notice = ui::ErrorMessages::remarks(name, remarks);
    if (!core::scaleMesh(mesh, insertion.unit)) {
        outcome.problem = ui::ErrorMessages::tooLarge(insertion.path);
        return;
    }
    if (insertion.repair) {
        const auto doing = [&](core::RepairStep step) { tell(ui::RepairMessages::progress(name, step)); };
        core::RepairResult legalised = core::repairMesh(mesh, *insertion.repair, control, doing);
        if (!legalised.mesh && !control.isCancelled())
            outcome.problem = ui::RepairMessages::refusal(insertion.path, legalised);
        if (!legalised.mesh)
            return;
        mesh = std::move(*legalised.mesh);
        for (core::Vec3f& p : mesh.points)
            p = (p.cast<double>() - legalised.report.moved).cast<float>();
        legalised.report.moved.setZero();
        outcome.mended = ui::RepairMessages::steps(legalised.report) << ui::RepairMessages::distance(legalised.report);
        tell(ModelWords::doing(command));
    }
    command.model = std::move(mesh);
}
} // namespace app
