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
void HeadsetDesk::takeMail()
{
    if (!m_port)
        return;
    HeadsetMail mail = m_port->takeMail();
    for (vr::DocumentRequest& wish : mail.wishes) {
        const bool isRefused = isForbidden(wish);
        if (HeadsetPort::holdsStrokes(wish))
            m_turns.push_back({m_port, std::move(wish), isRefused});
        else if (isRefused)
            forbid();
        else
            std::visit([this](const auto& what) { obey(what); }, wish);
    }
    obeyNext();
    if (mail.wasRefused)
        forbid();
    if (!mail.presence)
        return;
    m_wearerRadius = wearerOf(*mail.presence).radius;
    Q_EMIT seen(mail.presence);
}

/// One at a time: strokes between two wishes come to the document before the second.
void HeadsetDesk::obeyNext()
{
    if (m_turns.empty() || std::exchange(m_isObeying, true))
        return;
    const Turn turn = std::move(m_turns.front());
    m_turns.pop_front();
    m_document->inTurn([self = QPointer(this), turn] {
        if (!self)
            return;
        if (turn.isForbidden)
            self->forbid();
        else
            std::visit([self](const auto& wish) { self->obey(wish); }, turn.wish);
        self->m_document->inTurn([self, port = turn.port] {
            if (self)
                self->finish(port);
        });
    });
}

void HeadsetDesk::finish(const std::shared_ptr<HeadsetPort>& port)
{
    port->wishDone();
    m_isObeying = false;
    obeyNext();
}

void HeadsetDesk::refuse(const QString& sentence)
{
    tellNotice(sentence);
    Q_EMIT noticed(sentence);
}

void HeadsetDesk::obey(const vr::ChooseBrush& wish)
{
    const QScopedValueRollback choosing(m_isChoosing, true);
    using core::StrokeSettings;
    ui::BrushSettings& brush = *m_window->brush();
    brush.setTool(wish.brush.tool);
    if (!brush.isOffered(wish.brush.tool))
        refuseTool();
    brush.set(&StrokeSettings::brush, wish.brush.brush);
    brush.set(&StrokeSettings::topology, wish.brush.topology);
    brush.set(&StrokeSettings::symmetry, wish.brush.symmetry);
    brush.set(&StrokeSettings::radial, wish.brush.radial);
    brush.set(&StrokeSettings::color, wish.brush.color);
    m_toldBrush = brush.stroke();
}

/// The headset is told which tool there is instead.
void HeadsetDesk::refuseTool()
{
    refuse(tr("This class does without that tool."));
    ++m_news.brushChange;
}

void HeadsetDesk::obey(const vr::HeadsetSettings& choice)
{
    HeadsetSettings().setChoice(choice);
}

void HeadsetDesk::obey(const vr::Undo&)
{
    m_document->undo();
}

void HeadsetDesk::obey(const vr::Redo&)
{
    m_document->redo();
}

void HeadsetDesk::obey(const vr::RestoreModel&)
{
    if (m_document->isBusy())
        return refuse(tr("The model was not restored: other work on it is not done yet."));
    m_document->apply(core::Reset());
}

void HeadsetDesk::obey(const core::MaskOperation& change)
{
    if (m_document->isBusy())
        return refuse(tr("The mask was not changed: other work on the model is not done yet."));
    m_document->apply(change);
}

void HeadsetDesk::obey(const vr::SaveModel&)
{
    if (m_window->classroom())
        return refuse(tr("In a class the work is kept by Next Pupil, at the window."));
    if (m_document->isBusy())
        return refuse(tr("The model was not saved: other work on it is not done yet."));
    m_document->saveNumbered(QDir(folder()).filePath(m_document->facts().name));
}

void HeadsetDesk::obey(const vr::OpenModel& wish)
{
    const QString name = QFileInfo(wish.path).fileName();
    if (m_window->classroom())
        return refuse(tr("%1 was not opened: a class has its own models to begin with.").arg(name));
    if (m_document->isBusy())
        return refuse(tr("%1 was not opened: other work on the model is not done yet.").arg(name));
    if (wish.discardsChanges)
        return m_document->openLosingChanges(wish.path);
    if (m_document->isModified())
        return refuse(tr("%1 was not opened: the present model has changes that no file holds.").arg(name));
    m_document->open(wish.path);
}
} // namespace app
