#include "app/document/stroke_edit.h"

#include "ui/settings/brush_settings.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QAction>

#include <utility>

namespace app
{
namespace
{
/// What has taken longer is given up for a newer wish; what is faster is shown, so that who drags sees something.
constexpr int mostMs = 250;
} // namespace

StrokeEdit::StrokeEdit(ui::MainWindow& window, Document& document)
    : QObject(&document)
    , m_window(&window)
    , m_document(&document)
{
    QAction* action = window.action(QStringLiteral("edit.lastStroke"));
    action->setEnabled(false);
    connect(action, &QAction::triggered, this, [this] { m_document->inTurn([this] { begin(); }); });
    connect(m_document, &Document::historyChanged, action,
            [this, action] { action->setEnabled(m_document->lastStroke().has_value()); });
    connect(m_document, &Document::historyChanged, this, &StrokeEdit::watch);
    connect(m_document, &Document::opened, this, &StrokeEdit::end);
    connect(window.viewport(), &ui::Viewport::strokeBegan, this, &StrokeEdit::finish);
}

void StrokeEdit::begin()
{
    const auto stroke = m_document->lastStroke();
    if (!m_window || m_stroke || !stroke)
        return;
    m_stroke = stroke;
    m_present = core::brushOf(stroke->report.stroke()->settings);
    m_index = stroke->index + 1;
    m_isClosing = false;
    m_bar = new ui::StrokeEditBar(m_present, m_document->facts(), offeredTools(), m_window);
    connect(m_bar, &ui::StrokeEditBar::changed, this, &StrokeEdit::want);
    connect(m_bar, &ui::StrokeEditBar::accepted, this, &StrokeEdit::keep);
    connect(m_bar, &ui::StrokeEditBar::cancelled, this, &StrokeEdit::cancel);
}

QList<ui::ToolOption> StrokeEdit::offeredTools() const
{
    QList<ui::ToolOption> tools;
    for (const std::string_view name : core::toolNames()) {
        const core::Tool tool = core::toolNamed(name).value_or(m_present.tool);
        if (tool != m_present.tool && !m_window->brush()->isOffered(tool))
            continue;
        tools.append({tool, m_window->action(QStringLiteral("tool.") +
                                             QLatin1StringView(name.data(), static_cast<qsizetype>(name.size())))});
    }
    return tools;
}

void StrokeEdit::want(const core::BrushChange& brush)
{
    m_wanted = brush;
    if (m_isUnderWay && m_sinceBegin.elapsed() > mostMs)
        m_stop.request_stop();
    goOn();
}

void StrokeEdit::keep()
{
    m_isClosing = true;
    goOn();
}

void StrokeEdit::cancel()
{
    if (!m_stroke)
        return;
    m_isClosing = true;
    m_wanted = core::brushOf(m_stroke->report.stroke()->settings);
    m_stop.request_stop();
    goOn();
}

void StrokeEdit::goOn()
{
    if (!m_stroke || m_isUnderWay)
        return;
    const auto wanted = std::exchange(m_wanted, std::nullopt);
    if (wanted && *wanted != m_present)
        redo(*wanted);
    else if (m_isClosing)
        end();
}

void StrokeEdit::redo(const core::BrushChange& brush)
{
    m_present = brush;
    m_isUnderWay = true;
    m_sinceBegin.start();
    m_stop = std::stop_source();
    if (m_bar)
        m_bar->setHint({});
    const core::Stroke& before = *m_stroke->report.stroke();
    const bool isAsItWas = brush == core::brushOf(before.settings);
    m_document->redoStroke(*m_stroke,
                           isAsItWas ? nullptr : std::make_shared<const core::Stroke>(core::changed(before, brush)),
                           m_stop.get_token(), [this](const std::optional<StrokeReport>& report) { take(report); });
}

void StrokeEdit::take(const std::optional<StrokeReport>& report)
{
    m_isUnderWay = false;
    if (!report || !m_stroke)
        return end();
    m_index = m_document->undoStack().index();
    if (report->delta)
        m_present = core::brushOf(report->stroke()->settings); // it may have been stopped
    else if (m_bar)
        m_bar->setHint(tr("With this brush it does nothing."));
    goOn();
}

/// The hand begins the next stroke: what was wanted of this one comes before it.
void StrokeEdit::finish()
{
    if (m_stroke && m_wanted && *m_wanted != m_present)
        redo(*m_wanted);
    end();
}

/// What is not ours ends it.
void StrokeEdit::watch()
{
    if (m_stroke && !m_isUnderWay && m_document->undoStack().index() != m_index)
        end();
}

void StrokeEdit::end()
{
    m_stroke.reset();
    m_wanted.reset();
    if (m_bar)
        m_bar->dismiss();
    m_bar = nullptr;
}
} // namespace app
