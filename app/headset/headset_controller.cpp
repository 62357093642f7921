// What the headset is told of the document and of the window.

#include "app/headset/headset_controller.h"

#include "app/document/document.h"

#include "ui/brush/color_panel.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/settings.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QFileInfo>

#include <tuple>
#include <utility>

namespace app
{
namespace
{
/// What the headset takes from the window: not the radius, which is a length of its own there.
auto sharedSettings(const core::StrokeSettings& brush)
{
    return std::tuple(brush.tool, brush.brush, brush.topology, brush.symmetry, brush.radial, brush.color.r,
                      brush.color.g, brush.color.b, brush.falloff, brush.strength, brush.detail, brush.fusion,
                      brush.alpha, brush.alphaFollows, brush.model);
}
} // namespace

HeadsetController::HeadsetController(const Program& program, QObject* parent)
    : QObject(parent)
    , m_document(program.document)
    , m_worker(program.worker)
    , m_window(program.window)
    , m_colors(program.window->findChild<ui::ColorPanel*>())
{
    onBrushChanged();
    connectAll();
    connectPartner();
}

HeadsetController::~HeadsetController()
{
    if (m_port)
        m_port->end();
}

void HeadsetController::connectAll()
{
    connect(m_document, &Document::opened, this, [this] {
        ++m_update.model;
        updateFolder();
    });
    connect(m_document, &Document::busy, this, &HeadsetController::onBusyChanged);
    connect(m_document, &Document::idle, this, &HeadsetController::onBusyChanged);
    connect(m_document, &Document::modelInfoChanged, this, &HeadsetController::scheduleUpdate);
    connect(m_document, &Document::historyChanged, this, &HeadsetController::scheduleUpdate);
    connect(m_document, &Document::modifiedChanged, this, &HeadsetController::scheduleUpdate);
    connect(m_document, &Document::noticed, this, &HeadsetController::showNotice);
    connect(m_document, &Document::refused, this, &HeadsetController::showNotice);
    connect(m_document, &Document::repairable, this, [this](const QString&, const QString& problem) {
        showNotice(tr("%1 It can be mended at the window.").arg(problem));
    });
    connect(m_document, &Document::saved, this, [this](const QString& path) {
        m_update.saved = QFileInfo(path).fileName();
        updateFolder();
    });
    connect(m_window->brush(), &ui::BrushSettings::changed, this, &HeadsetController::onBrushChanged);
    connect(m_window->viewport(), &ui::Viewport::appearanceChanged, this, &HeadsetController::scheduleUpdate);
    connect(m_colors, &ui::ColorPanel::swatchesChanged, this, &HeadsetController::scheduleUpdate);
    connect(&m_files, &HeadsetFiles::changed, this, &HeadsetController::scheduleUpdate);
}

std::shared_ptr<HeadsetPort> HeadsetController::open()
{
    ++m_update.brushChange; // nothing of it is known there
    m_update.saved.clear();
    m_update.notice.clear();
    m_update.noticeCount = 0;
    beginPartner();
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
    m_choiceTimer.stop();
    m_files.stop();
    Q_EMIT avatarChanged({});
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
    if (!m_isChoosing && sharedSettings(brush) != sharedSettings(m_update.brush)) {
        ++m_update.brushChange;
        m_choiceTimer.start();
    }
    m_update.brush = brush;
    scheduleUpdate();
}

/// Where the model lies now. A class is shown no files.
void HeadsetController::updateFolder()
{
    if (m_port && !m_window->classroom())
        m_files.watch(folder());
    scheduleUpdate();
}

/// At once: a stroke may begin at any moment.
void HeadsetController::onBusyChanged()
{
    if (m_port)
        m_port->setRefusing(m_document->isOpening());
    scheduleUpdate();
}

/// One of many changes that come together.
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
    checkRadius();
    vr::DocumentUpdate update = m_update;
    const ui::Viewport& viewport = *m_window->viewport();
    update.box = m_document->modelInfo().box;
    update.shading = viewport.shading();
    update.isFlat = viewport.appearance().flat;
    update.smooths = m_window->brush()->isOffered(core::Tool::Smooth);
    update.reducesMotion = viewport.reducesMotion();
    update.canUndo = m_document->canUndo();
    update.canRedo = m_document->canRedo();
    m_undoText = m_document->undoText();
    m_redoText = m_document->redoText();
    update.isModified = m_document->isModified();
    update.isBusy = m_document->isBusy();
    update.swatches = m_colors->swatches();
    update.folder = m_files.name();
    update.files = m_files.tiles();
    m_port->setUpdate(std::move(update));
}

QString HeadsetController::folder() const
{
    const QString& path = m_document->path();
    return path.isEmpty() ? ui::Settings().lastFolder() : QFileInfo(path).absolutePath();
}
} // namespace app
