#include "app/headset/headset_requests.h"

#include "app/document/document.h"
#include "app/headset/headset_files.h"
#include "app/headset/headset_settings_store.h"
#include "app/headset/partner_view.h"

#include "ui/settings/brush_settings.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QPointer>
#include <QScopedValueRollback>

#include <utility>

namespace app
{
HeadsetRequests::HeadsetRequests(Document* document, ui::MainWindow* window, PartnerView* partner)
    : m_document(document)
    , m_window(window)
    , m_partner(partner)
{}

void HeadsetRequests::enqueue(const std::shared_ptr<HeadsetPort>& port, std::deque<vr::DocumentRequest> requests)
{
    for (vr::DocumentRequest& request : requests) {
        const bool isRefused = isForbidden(request), holdsStrokes = HeadsetPort::holdsStrokes(request);
        if (holdsStrokes && !isRefused && isPreviewing()) {
            answerInPreview(request);
            port->requestDone();
        } else if (holdsStrokes) {
            m_previews += !isRefused && std::holds_alternative<vr::PreviewParts>(request);
            m_turns.push_back({port, std::move(request), isRefused});
        } else if (isRefused)
            m_partner->refuse();
        else
            std::visit([this](const auto& what) { handle(what); }, request);
    }
    handleNext();
}

/// Returns whether the request must be refused. While the window has taken over, the headset may change neither the
/// model nor the shared brush.
bool HeadsetRequests::isForbidden(const vr::DocumentRequest& request) const
{
    return m_partner->isTakenOver() && !std::holds_alternative<vr::HeadsetSettings>(request) &&
           !std::holds_alternative<vr::SaveModel>(request);
}

/// Returns whether a preview is shown, being computed, or requested.
bool HeadsetRequests::isPreviewing() const
{
    return m_previews > 0 || m_document->changer().isPreviewing();
}

/// Answers a request that comes during a preview, which has to end before the document goes on.
void HeadsetRequests::answerInPreview(const vr::DocumentRequest& request)
{
    if (std::holds_alternative<vr::Undo>(request))
        m_document->changer().dropPreview();
    else
        Q_EMIT refused(tr("Apply or cancel the preview first."));
}

/// Handles one request at a time, so that strokes between two requests reach the document before the second request.
void HeadsetRequests::handleNext()
{
    if (m_turns.empty() || std::exchange(m_isHandling, true))
        return;
    const Turn turn = std::move(m_turns.front());
    m_turns.pop_front();
    m_document->queue().enqueue([self = QPointer(this), turn] {
        if (!self)
            return;
        if (turn.isForbidden)
            self->m_partner->refuse();
        else
            std::visit([self](const auto& request) { self->handle(request); }, turn.request);
        self->m_document->queue().enqueue([self, turn] { // after a preview that the request has begun
            if (self)
                self->finish(turn);
        });
    });
}

void HeadsetRequests::finish(const Turn& turn)
{
    turn.port->requestDone();
    m_previews -= !turn.isForbidden && std::holds_alternative<vr::PreviewParts>(turn.request);
    m_isHandling = false;
    handleNext();
}

bool HeadsetRequests::isBusy(const QString& sentence)
{
    const bool isBusy = m_document->job().isBusy();
    if (isBusy)
        Q_EMIT refused(sentence);
    return isBusy;
}

void HeadsetRequests::handle(const vr::ChooseBrush& request)
{
    const QScopedValueRollback choosing(m_isChoosing, true);
    using core::StrokeSettings;
    ui::BrushSettings& brush = *m_window->brush();
    brush.setTool(request.brush.tool);
    if (!brush.isOffered(request.brush.tool)) { // the headset is then told which tool is selected instead
        Q_EMIT refused(tr("This tool is not available in this class."));
        Q_EMIT brushRefused();
    }
    brush.set(&StrokeSettings::brush, request.brush.brush);
    brush.setUniform(request.brush.topology == core::Topology::Uniform);
    brush.set(&StrokeSettings::symmetry, request.brush.symmetry);
    brush.set(&StrokeSettings::radial, request.brush.radial);
    brush.set(&StrokeSettings::color, request.brush.color);
    m_partner->setKnownBrush(brush.stroke());
}

void HeadsetRequests::handle(const vr::HeadsetSettings& settings)
{
    HeadsetSettingsStore().save(settings);
}

void HeadsetRequests::handle(vr::LessonRequest request)
{
    m_partner->press(request);
}

void HeadsetRequests::handle(const vr::Undo&)
{
    m_document->history().undo();
}

void HeadsetRequests::handle(const vr::Redo&)
{
    m_document->history().redo();
}

void HeadsetRequests::handle(const vr::RestoreModel&)
{
    if (!isBusy(tr("The model was not restored: another operation on it is still running.")))
        m_document->changer().apply(core::Reset());
}

void HeadsetRequests::handle(const core::MaskOperation& change)
{
    if (!isBusy(tr("The mask was not changed: another operation on the model is still running.")))
        m_document->changer().apply(change);
}

void HeadsetRequests::handle(const vr::ActivatePart& request)
{
    m_document->parts().activate(request.part);
}

void HeadsetRequests::handle(const vr::PickPart& request)
{
    m_document->parts().pick(request.ray);
}

bool HeadsetRequests::isBusyForParts()
{
    return isBusy(tr("The parts were not changed: another operation on the model is still running."));
}

void HeadsetRequests::handle(const vr::IsolatePart&)
{
    if (!isBusyForParts())
        m_document->parts().isolate();
}

void HeadsetRequests::handle(const vr::ChangePart& request)
{
    if (!isBusyForParts())
        m_document->changer().applyTo(request.part, request.command);
}

void HeadsetRequests::handle(const vr::PreviewParts& request)
{
    if (!isBusyForParts())
        m_document->changer().preview(request.part, request.command);
}

void HeadsetRequests::handle(const vr::PreviewInstead& request)
{
    m_document->changer().previewInstead(request.operation);
}

void HeadsetRequests::handle(const vr::EndPreview& request)
{
    if (request.isApplied)
        m_document->changer().applyPreview();
    else
        m_document->changer().dropPreview();
}

void HeadsetRequests::handle(const vr::SaveModel&)
{
    if (m_window->classroom())
        return Q_EMIT refused(tr("In a class, Next Pupil saves the work, in the window."));
    const ui::ModelInfo& info = m_document->modelInfo();
    if (!isBusy(tr("The model was not saved: another operation on it is still running.")))
        m_document->saver().saveNumbered(QDir(HeadsetFiles::folderOf(info.path)).filePath(info.name));
}

void HeadsetRequests::handle(const vr::OpenModel& request)
{
    const QString name = QFileInfo(request.path).fileName();
    if (m_window->classroom())
        return Q_EMIT refused(tr("%1 was not opened: during a class, only its starting models can be used.").arg(name));
    if (isBusy(tr("%1 was not opened: another operation on the model is still running.").arg(name)))
        return;
    if (request.discardsChanges)
        return m_document->opener().openDiscardingChanges(request.path);
    if (m_document->savedState().isModified())
        return Q_EMIT refused(tr("%1 was not opened: the current model has unsaved changes.").arg(name));
    m_document->opener().open(request.path);
}
} // namespace app
