#include "app/document/time_lapse_controller.h"

#include "app/document/document.h"
#include "app/document/history_visit.h"

#include "ui/history/time_lapse_dialog.h"
#include "ui/settings/settings.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QDir>

#include <algorithm>
#include <memory>

namespace app
{
namespace
{
/// Returns a view whose picture contains everything visible in the window.
core::ThumbnailView viewOf(const ui::OrbitCamera& camera, const ui::TimeLapseSettings& settings)
{
    core::ThumbnailView view;
    view.axes << camera.right().transpose(), camera.up().transpose(), -camera.viewDirection().transpose();
    view.target = camera.target();
    view.distance = camera.projection() == ui::OrbitCamera::Projection::Perspective ? camera.distance() : 0;
    const Eigen::Vector2d shown = camera.viewport() / camera.pixelsPerMm(camera.target());
    view.extent = std::max(shown.y(), shown.x() * settings.height / settings.width);
    view.width = settings.width;
    view.height = settings.height;
    return view;
}
} // namespace

TimeLapseController::TimeLapseController(ui::MainWindow& window, Document& document)
    : QObject(&document)
    , m_window(&window)
    , m_document(&document)
{
    connect(window.action(QStringLiteral("file.timeLapse")), &QAction::triggered, this, &TimeLapseController::ask);
}

void TimeLapseController::ask()
{
    const int steps = m_document->history().stack().index() - m_document->history().store().firstIndex();
    ui::askForTimeLapse(m_window, steps, [this](const ui::TimeLapseSettings& settings) {
        ui::askForFolder(m_window, ui::Settings().lastFolder(),
                         [this, settings](const QString& folder) { write(settings, folder); });
    });
}

void TimeLapseController::write(const ui::TimeLapseSettings& settings, const QString& folder)
{
    if (!m_window)
        return;
    const TimeLapseRequest request{folder, settings.every, viewOf(m_window->viewport()->camera(), settings)};
    const auto outcome = std::make_shared<TimeLapseOutcome>();
    const auto visit = [request, outcome](const ModelHistory& history, const core::JobControl& control) {
        *outcome = TimeLapse::run(request, history, control);
    };
    if (!visitHistory(*m_document, tr("Drawing the time-lapse"), visit,
                      [this, folder, outcome] { finish(folder, *outcome); }))
        m_window->showNotice(tr("The time-lapse has to wait until this is done; try again then."));
}

void TimeLapseController::finish(const QString& folder, const TimeLapseOutcome& outcome)
{
    if (!m_window)
        return;
    const QString place = QDir::toNativeSeparators(folder);
    if (!outcome.problem.isEmpty())
        m_window->showProblem(outcome.problem);
    else if (outcome.frames > 0)
        m_window->showNotice(tr("%1: %Ln pictures were written.", nullptr, outcome.frames).arg(place));
    else
        m_window->showNotice(tr("The time-lapse was stopped; no picture of it is in %1.").arg(place));
}
} // namespace app
