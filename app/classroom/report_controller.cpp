#include "app/classroom/report_controller.h"

#include "app/classroom/report_writer.h"
#include "app/model/model_loader.h"
#include "app/worker/background_job.h"

#include "core/io/mesh_io.h"
#include "ui/util/error_messages.h"
#include "ui/util/format_filters.h"

#include <QFileInfo>
#include <QPointer>

namespace app
{
namespace
{
ReportOutcome outcomeOf(const ReportRequest& request, const core::JobControl& control)
{
    try {
        ReportWriter::run(request, control);
        return {{}, true};
    } catch (const core::FileError& error) {
        return {ui::ErrorMessages::sentence(error), false};
    } catch (const core::ReadingCancelled&) {
        return {};
    }
}
} // namespace

ReportController::ReportController(BackgroundJob* job, QObject* parent) : QObject(parent), m_job(job) {}

void ReportController::write(const QString& folder, const QString& path)
{
    if (!ui::reportEndings().contains(QFileInfo(path).suffix().toLower()))
        return Q_EMIT refused(ui::ErrorMessages::notAReport(path));
    if (m_job->isBusy()) // another job began while the dialogs were open
        return Q_EMIT noticed(tr("The class report has to wait until this is done; try again then."));
    const core::JobControl control =
        m_job->beginCancellable(tr("Looking at the models in %1").arg(QFileInfo(folder).fileName()));
    auto work = [request = ReportRequest{toPath(folder), toPath(path)}, control] {
        return outcomeOf(request, control);
    };
    m_job->run(work, [self = QPointer(this), path](const ReportOutcome& outcome) {
        if (self)
            self->finish(path, outcome);
    });
}

void ReportController::finish(const QString& path, const ReportOutcome& outcome)
{
    m_job->commit();
    m_job->end();
    if (!outcome.problem.isEmpty())
        return Q_EMIT refused(outcome.problem);
    Q_EMIT noticed(outcome.isWritten ? tr("Saved %1.").arg(QFileInfo(path).fileName())
                                     : tr("%1 was not written.").arg(QFileInfo(path).fileName()));
}
} // namespace app
