#include "app/classroom/report_controller.h"

#include "app/classroom/report_writer.h"
#include "app/model/model_loader.h"
#include "app/worker/background_job.h"

#include "core/io/mesh_io.h"
#include "ui/util/error_messages.h"
#include "ui/util/format_filters.h"

#include <QDir>
#include <QFileInfo>
#include <QPointer>

namespace app
{
namespace
{
ReportOutcome outcomeOf(const ReportOrder& order, const core::JobControl& control)
{
    try {
        ReportMaker::run(order, control);
        return {{}, true};
    } catch (const core::FileError& error) {
        return {ui::ErrorMessages::sentence(error), false};
    } catch (const core::ReadingCancelled&) {
        return {};
    }
}
} // namespace

ReportDesk::ReportDesk(LongWork* work, QObject* parent) : QObject(parent), m_work(work) {}

void ReportDesk::write(const QString& folder, const QString& path)
{
    if (!ui::reportEndings().contains(QFileInfo(path).suffix().toLower()))
        return Q_EMIT refused(ui::ErrorMessages::notAReport(path));
    if (m_work->isBusy()) // it began while the dialogs were open
        return Q_EMIT noticed(tr("The class report has to wait until this is done; ask for it again then."));
    const core::JobControl control =
        m_work->beginStoppable(tr("Looking at the models in %1").arg(QFileInfo(folder).fileName()));
    auto work = [order = ReportOrder{toPath(folder), toPath(path)}, control] { return outcomeOf(order, control); };
    m_work->run(work, [self = QPointer(this), path](const ReportOutcome& outcome) {
        if (self)
            self->finish(path, outcome);
    });
}

void ReportDesk::finish(const QString& path, const ReportOutcome& outcome)
{
    m_work->keep();
    m_work->end();
    if (!outcome.problem.isEmpty())
        return Q_EMIT refused(outcome.problem);
    Q_EMIT noticed(
        (outcome.isWritten ? tr("%1 was written.") : tr("%1 was not written.")).arg(QDir::toNativeSeparators(path)));
}
} // namespace app
