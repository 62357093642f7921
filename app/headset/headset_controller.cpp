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
auto chosen(const core::StrokeSettings& brush)
{
    return std::tuple(brush.tool, brush.brush, brush.topology, brush.symmetry, brush.radial, brush.color.r,
                      brush.color.g, brush.color.b, brush.falloff, brush.strength, brush.detail, brush.fusion,
                      brush.alpha, brush.alphaFollows, brush.model);
}
} // namespace

HeadsetDesk::HeadsetDesk(const Program& program, QObject* parent)
    : QObject(parent)
    , m_document(program.document)
    , m_worker(program.worker)
    , m_window(program.window)
    , m_colors(program.window->findChild<ui::ColorPanel*>())
{
    takeBrush();
    hear();
    hearPartner();
}

HeadsetDesk::~HeadsetDesk()
{
    if (m_port)
        m_port->end();
}

void HeadsetDesk::hear()
{
    connect(m_document, &Document::opened, this, [this] {
        ++m_news.model;
        lookForFiles();
    });
    connect(m_document, &Document::busy, this, &HeadsetDesk::takeBusy);
    connect(m_document, &Document::idle, this, &HeadsetDesk::takeBusy);
    connect(m_document, &Document::factsChanged, this, &HeadsetDesk::tellSoon);
    connect(m_document, &Document::historyChanged, this, &HeadsetDesk::tellSoon);
    connect(m_document, &Document::modifiedChanged, this, &HeadsetDesk::tellSoon);
    connect(m_document, &Document::noticed, this, &HeadsetDesk::tellNotice);
    connect(m_document, &Document::refused, this, &HeadsetDesk::tellNotice);
    connect(m_document, &Document::mendable, this, [this](const QString&, const QString& problem) {
        tellNotice(tr("%1 It can be mended at the window.").arg(problem));
    });
    connect(m_document, &Document::saved, this, [this](const QString& path) {
        m_news.saved = QFileInfo(path).fileName();
        lookForFiles();
    });
    connect(m_window->brush(), &ui::BrushSettings::changed, this, &HeadsetDesk::takeBrush);
    connect(m_window->viewport(), &ui::Viewport::appearanceChanged, this, &HeadsetDesk::tellSoon);
    connect(m_colors, &ui::ColorPanel::swatchesChanged, this, &HeadsetDesk::tellSoon);
    connect(&m_files, &HeadsetFiles::changed, this, &HeadsetDesk::tellSoon);
}

std::shared_ptr<HeadsetPort> HeadsetDesk::open()
{
    ++m_news.brushChange; // nothing of it is known there
    m_news.saved.clear();
    m_news.notice.clear();
    m_news.noticeCount = 0;
    beginPartner();
    m_port = std::make_shared<HeadsetPort>(m_worker);
    connect(m_port.get(), &HeadsetPort::mailCame, this, &HeadsetDesk::takeMail, Qt::QueuedConnection);
    m_port->begin();
    lookForFiles();
    takeBusy();
    tell();
    return m_port;
}

void HeadsetDesk::close()
{
    if (!m_port)
        return;
    m_port->end();
    takeMail();
    m_port.reset();
    m_choice.stop();
    m_files.stop();
    Q_EMIT seen({});
}

void HeadsetDesk::tellNotice(const QString& sentence)
{
    m_news.notice = sentence;
    ++m_news.noticeCount;
    tellSoon();
}

void HeadsetDesk::takeBrush()
{
    const core::StrokeSettings& brush = m_window->brush()->stroke();
    if (brush.symmetry != core::Symmetry::None)
        m_news.plane = brush.symmetry;
    if (!m_isChoosing && chosen(brush) != chosen(m_news.brush)) {
        ++m_news.brushChange;
        m_choice.start();
    }
    m_news.brush = brush;
    tellSoon();
}

/// Where the model lies now. A class is shown no files.
void HeadsetDesk::lookForFiles()
{
    if (m_port && !m_window->classroom())
        m_files.look(folder());
    tellSoon();
}

/// At once: a stroke may begin at any moment.
void HeadsetDesk::takeBusy()
{
    if (m_port)
        m_port->setRefusing(m_document->isOpening());
    tellSoon();
}

/// One of many changes that come together.
void HeadsetDesk::tellSoon()
{
    if (m_port && !std::exchange(m_tellsSoon, true))
        QMetaObject::invokeMethod(this, "tell", Qt::QueuedConnection);
}

void HeadsetDesk::tell()
{
    m_tellsSoon = false;
    if (!m_port)
        return;
    takeRadius();
    vr::DocumentUpdate news = m_news;
    const ui::Viewport& viewport = *m_window->viewport();
    news.box = m_document->facts().box;
    news.shading = viewport.shading();
    news.isFlat = viewport.appearance().flat;
    news.smooths = m_window->brush()->isOffered(core::Tool::Smooth);
    news.reducesMotion = viewport.reducesMotion();
    news.canUndo = m_document->canUndo();
    news.canRedo = m_document->canRedo();
    m_undoText = m_document->undoText();
    m_redoText = m_document->redoText();
    news.isModified = m_document->isModified();
    news.isBusy = m_document->isBusy();
    news.swatches = m_colors->swatches();
    news.folder = m_files.name();
    news.files = m_files.tiles();
    m_port->tell(std::move(news));
}

QString HeadsetDesk::folder() const
{
    const QString& path = m_document->path();
    return path.isEmpty() ? ui::Settings().lastFolder() : QFileInfo(path).absolutePath();
}
} // namespace app
