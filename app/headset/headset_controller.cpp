#include "app/headset/headset_controller.h"

#include "app/document/document.h"
#include "app/headset/avatar.h"

#include "ui/brush/color_panel.h"
#include "ui/scene/materials.h"
#include "ui/settings/brush_settings.h"
#include "ui/util/part_name.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QFileInfo>

#include <tuple>
#include <utility>

namespace app
{
namespace
{
/// Returns the brush settings that the headset takes from the window. The radius is not one of them: the headset has a
/// radius of its own.
auto sharedSettings(const core::StrokeSettings& brush)
{
    return std::tuple(brush.tool, brush.brush, brush.topology, brush.symmetry, brush.radial, brush.color.r,
                      brush.color.g, brush.color.b, brush.falloff, brush.strength, brush.detail, brush.fusion,
                      brush.alpha, brush.alphaFollows, brush.anchored, brush.model);
}
} // namespace

HeadsetController::HeadsetController(const Program& program, QObject* parent)
    : QObject(parent)
    , m_document(program.document)
    , m_worker(program.worker)
    , m_window(program.window)
    , m_colors(program.window->findChild<ui::ColorPanel*>())
    , m_partner(program.document, program.window)
    , m_requests(program.document, program.window, &m_partner)
{
    onBrushChanged();
    connectDocument();
    connectParts();
}

HeadsetController::~HeadsetController()
{
    if (m_port)
        m_port->end();
}

void HeadsetController::connectDocument()
{
    connect(m_document, &Document::opened, this, [this] {
        ++m_update.model;
        updateFolder();
    });
    connect(&m_document->job(), &BackgroundJob::busy, this, &HeadsetController::onBusyChanged);
    connect(&m_document->job(), &BackgroundJob::idle, this, &HeadsetController::onBusyChanged);
    connect(m_document, &Document::modelInfoChanged, this, &HeadsetController::scheduleUpdate);
    connect(m_document, &Document::historyChanged, this, &HeadsetController::scheduleUpdate);
    connect(&m_document->savedState(), &SavedState::modifiedChanged, this, &HeadsetController::scheduleUpdate);
    connect(&m_document->parts(), &DocumentParts::changed, this, &HeadsetController::scheduleUpdate);
    const ModelChanger* changer = &m_document->changer();
    connect(changer, &ModelChanger::previewed, this, [this](core::SetOperation operation, const auto& translucent) {
        m_update.preview = operation;
        m_update.translucent = translucent;
        scheduleUpdate();
    });
    const auto hidePreview = [this] {
        m_update.preview.reset();
        m_update.translucent.reset();
        onBusyChanged();
    };
    connect(changer, &ModelChanger::previewTakenBack, this, hidePreview);
    connect(changer, &ModelChanger::previewEnded, this, hidePreview);
    connect(m_document, &Document::noticed, this, &HeadsetController::showNotice);
    connect(m_document, &Document::refused, this, &HeadsetController::showNotice);
    connect(&m_document->opener(), &ModelOpener::repairable, this, [this](const QString&, const QString& problem) {
        showNotice(tr("%1 You can repair it in the window.").arg(problem));
    });
    connect(&m_document->saver(), &ModelSaver::saved, this, [this](const QString& path) {
        m_update.saved = QFileInfo(path).fileName();
        updateFolder();
    });
    connect(m_window->brush(), &ui::BrushSettings::changed, this, &HeadsetController::onBrushChanged);
    connect(m_window->brush(), &ui::BrushSettings::inputChanged, this, &HeadsetController::scheduleUpdate);
    connect(m_window->viewport(), &ui::Viewport::appearanceChanged, this, &HeadsetController::scheduleUpdate);
    connect(m_colors, &ui::ColorPanel::swatchesChanged, this, &HeadsetController::scheduleUpdate);
}

void HeadsetController::connectParts()
{
    const auto resendBrush = [this] { ++m_update.brushChange; };
    connect(&m_files, &HeadsetFiles::changed, this, &HeadsetController::scheduleUpdate);
    connect(&m_partner, &PartnerView::changed, this, &HeadsetController::scheduleUpdate);
    connect(&m_partner, &PartnerView::noticed, this, &HeadsetController::showNotice);
    connect(&m_partner, &PartnerView::brushRefused, this, resendBrush);
    connect(&m_partner, &PartnerView::takenOver, this, [this](bool isTakenOver) { m_port->setTakenOver(isTakenOver); });
    connect(&m_requests, &HeadsetRequests::brushRefused, this, resendBrush);
    connect(&m_requests, &HeadsetRequests::refused, this, &HeadsetController::showNotice);
    connect(&m_requests, &HeadsetRequests::refused, this, &HeadsetController::noticed);
}

std::shared_ptr<HeadsetPort> HeadsetController::open()
{
    ++m_update.brushChange; // the headset knows no settings yet, so all are sent
    m_update.saved.clear();
    m_update.notice.clear();
    m_update.noticeCount = 0;
    m_partner.begin(m_update.model);
    m_port = std::make_shared<HeadsetPort>(m_worker);
    connect(m_port.get(), &HeadsetPort::messagesArrived, this, &HeadsetController::takeMessages, Qt::QueuedConnection);
    m_port->begin();
    updateFolder();
    onBusyChanged();
    sendUpdate();
    return m_port;
}

void HeadsetController::close()
{
    if (!m_port)
        return;
    m_port->end();
    takeMessages();
    m_port.reset();
    m_partner.end();
    m_files.stop();
    Q_EMIT avatarChanged({});
}

void HeadsetController::takeMessages()
{
    if (!m_port)
        return;
    HeadsetMessages messages = m_port->takeMessages();
    m_requests.enqueue(m_port, std::move(messages.requests));
    if (messages.wasRefused)
        m_partner.refuse();
    if (!messages.avatar)
        return;
    m_partner.setAvatarRadius(avatarOf(*messages.avatar).radius);
    Q_EMIT avatarChanged(messages.avatar);
}

void HeadsetController::showNotice(const QString& sentence)
{
    m_update.notice = sentence;
    ++m_update.noticeCount;
    scheduleUpdate();
}

void HeadsetController::onBrushChanged()
{
    const core::StrokeSettings& brush = m_window->brush()->stroke();
    if (brush.symmetry != core::Symmetry::None)
        m_update.plane = brush.symmetry;
    if (!m_requests.isChoosing() && sharedSettings(brush) != sharedSettings(m_update.brush)) {
        ++m_update.brushChange;
        m_partner.startChoiceTimer();
    }
    m_update.brush = brush;
    scheduleUpdate();
}

/// Tells the headset the folder of the model. In a class no files are shown.
void HeadsetController::updateFolder()
{
    if (m_port && !m_window->classroom())
        m_files.watch(HeadsetFiles::folderOf(m_document->modelInfo().path));
    scheduleUpdate();
}

/// Takes effect at once, because a stroke may begin at any moment.
void HeadsetController::onBusyChanged()
{
    if (m_port)
        m_port->setRefusing(m_document->opener().isOpening() || m_document->changer().isPreviewing());
    scheduleUpdate();
}

/// Schedules one update for all changes in the present iteration of the event loop.
void HeadsetController::scheduleUpdate()
{
    if (m_port && !std::exchange(m_isUpdateScheduled, true))
        QMetaObject::invokeMethod(this, &HeadsetController::sendUpdate, Qt::QueuedConnection);
}

void HeadsetController::sendUpdate()
{
    m_isUpdateScheduled = false;
    if (!m_port)
        return;
    vr::DocumentUpdate update = m_update;
    m_partner.addTo(update);
    const ui::Viewport& viewport = *m_window->viewport();
    update.box = m_document->modelInfo().box;
    update.shading = ui::shadingOf(viewport.appearance().material);
    update.isFlat = viewport.appearance().flat;
    update.hasTint = viewport.appearance().tint;
    update.hasCavity = viewport.appearance().cavity;
    update.smooths = m_window->brush()->isOffered(core::Tool::Smooth);
    for (std::size_t i = 0; i < update.airbrush.size(); ++i)
        update.airbrush[i] = m_window->brush()->tools()->airbrush(static_cast<core::Tool>(i));
    update.smoothStrength = m_window->brush()->tools()->of(core::Tool::Smooth).strength;
    update.reducesMotion = viewport.reducesMotion();
    update.canUndo = m_document->history().canUndo();
    update.canRedo = m_document->history().canRedo();
    update.isModified = m_document->savedState().isModified();
    update.isBusy = m_document->job().isBusy();
    update.swatches = m_colors->swatches();
    for (const core::Part& part : m_document->parts().list().all())
        update.parts << vr::PartRow{part, ui::partName(part)};
    update.activePart = m_document->parts().active();
    update.folder = m_files.name();
    update.files = m_files.tiles();
    m_port->setUpdate(std::move(update));
}
} // namespace app
