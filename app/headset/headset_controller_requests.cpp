// What the person in the headset wants of the document and of the window.

#include "app/headset/headset_controller.h"

#include "app/document/document.h"
#include "app/headset/avatar.h"
#include "app/headset/headset_settings.h"

#include "ui/settings/brush_settings.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QPointer>
#include <QScopedValueRollback>

#include <utility>

namespace app
{
void HeadsetController::takeMessages()
{
    if (!m_port)
        return;
    HeadsetMessages messages = m_port->takeMessages();
    for (vr::DocumentRequest& request : messages.requests) {
        const bool isRefused = isForbidden(request);
        if (HeadsetPort::holdsStrokes(request))
            m_turns.push_back({m_port, std::move(request), isRefused});
        else if (isRefused)
            rejectRequest();
        else
            std::visit([this](const auto& what) { handle(what); }, request);
    }
    handleNext();
    if (messages.wasRefused)
        rejectRequest();
    if (!messages.avatar)
        return;
    m_avatarRadius = avatarOf(*messages.avatar).radius;
    Q_EMIT avatarChanged(messages.avatar);
}

/// One at a time: strokes between two wishes come to the document before the second.
void HeadsetController::handleNext()
{
    if (m_turns.empty() || std::exchange(m_isHandling, true))
        return;
    const Turn turn = std::move(m_turns.front());
    m_turns.pop_front();
    m_document->enqueue([self = QPointer(this), turn] {
        if (!self)
            return;
        if (turn.isForbidden)
            self->rejectRequest();
        else
            std::visit([self](const auto& request) { self->handle(request); }, turn.request);
        self->m_document->enqueue([self, port = turn.port] {
            if (self)
                self->finish(port);
        });
    });
}

void HeadsetController::finish(const std::shared_ptr<HeadsetPort>& port)
{
    port->requestDone();
    m_isHandling = false;
    handleNext();
}

void HeadsetController::refuse(const QString& sentence)
{
    showNotice(sentence);
    Q_EMIT noticed(sentence);
}

void HeadsetController::handle(const vr::ChooseBrush& request)
{
    const QScopedValueRollback choosing(m_isChoosing, true);
    using core::StrokeSettings;
    ui::BrushSettings& brush = *m_window->brush();
    brush.setTool(request.brush.tool);
    if (!brush.isOffered(request.brush.tool))
        refuseTool();
    brush.set(&StrokeSettings::brush, request.brush.brush);
    brush.set(&StrokeSettings::topology, request.brush.topology);
    brush.set(&StrokeSettings::symmetry, request.brush.symmetry);
    brush.set(&StrokeSettings::radial, request.brush.radial);
    brush.set(&StrokeSettings::color, request.brush.color);
    m_knownBrush = brush.stroke();
}

/// The headset is told which tool there is instead.
void HeadsetController::refuseTool()
{
    refuse(tr("This class does without that tool."));
    ++m_update.brushChange;
}

void HeadsetController::handle(const vr::HeadsetSettings& settings)
{
    HeadsetSettings().save(settings);
}

void HeadsetController::handle(const vr::Undo&)
{
    m_document->undo();
}

void HeadsetController::handle(const vr::Redo&)
{
    m_document->redo();
}

void HeadsetController::handle(const vr::RestoreModel&)
{
    if (m_document->isBusy())
        return refuse(tr("The model was not restored: other work on it is not done yet."));
    m_document->apply(core::Reset());
}

void HeadsetController::handle(const core::MaskOperation& change)
{
    if (m_document->isBusy())
        return refuse(tr("The mask was not changed: other work on the model is not done yet."));
    m_document->apply(change);
}

void HeadsetController::handle(const vr::SaveModel&)
{
    if (m_window->classroom())
        return refuse(tr("In a class the work is kept by Next Pupil, at the window."));
    if (m_document->isBusy())
        return refuse(tr("The model was not saved: other work on it is not done yet."));
    m_document->saveNumbered(QDir(folder()).filePath(m_document->modelInfo().name));
}

void HeadsetController::handle(const vr::OpenModel& request)
{
    const QString name = QFileInfo(request.path).fileName();
    if (m_window->classroom())
        return refuse(tr("%1 was not opened: a class has its own models to begin with.").arg(name));
    if (m_document->isBusy())
        return refuse(tr("%1 was not opened: other work on the model is not done yet.").arg(name));
    if (request.discardsChanges)
        return m_document->openDiscardingChanges(request.path);
    if (m_document->isModified())
        return refuse(tr("%1 was not opened: the present model has changes that no file holds.").arg(name));
    m_document->open(request.path);
}
} // namespace app
