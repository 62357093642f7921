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
/// Time after which a newer request cancels a replacement, ms. A faster replacement is finished and shown, so that
/// dragging a slider shows intermediate results.
constexpr int maxReplaceMs = 250;
} // namespace

StrokeEdit::StrokeEdit(ui::MainWindow& window, Document& document)
    : QObject(&document)
    , m_window(&window)
    , m_document(&document)
{
    QAction* action = window.action(QStringLiteral("edit.lastStroke"));
    action->setEnabled(false);
    connect(action, &QAction::triggered, this, [this] { m_document->queue().enqueue([this] { begin(); }); });
    connect(m_document, &Document::historyChanged, action,
            [this, action] { action->setEnabled(m_document->lastStroke().step().has_value()); });
    connect(m_document, &Document::historyChanged, this, &StrokeEdit::checkHistory);
    connect(m_document, &Document::opened, this, &StrokeEdit::end);
    connect(window.viewport()->input(), &ui::PointerInput::strokeBegan, this, &StrokeEdit::finish);
}

void StrokeEdit::begin()
{
    const auto stroke = m_document->lastStroke().step();
    if (!m_window || m_stroke || !stroke)
        return;
    m_stroke = stroke;
    m_present = core::brushOf(stroke->report.stroke()->settings);
    m_index = stroke->index + 1;
    m_isClosing = false;
    m_bar = new ui::StrokeEditBar(m_present, m_document->modelInfo(), offeredTools(), m_window);
    connect(m_bar, &ui::StrokeEditBar::changed, this, &StrokeEdit::requestBrush);
    connect(m_bar, &ui::StrokeEditBar::accepted, this, &StrokeEdit::accept);
    connect(m_bar, &ui::StrokeEditBar::cancelled, this, &StrokeEdit::cancel);
}

QList<ui::ToolOption> StrokeEdit::offeredTools() const
{
    QList<ui::ToolOption> tools;
    for (const std::string_view name : core::toolNames()) {
        const core::Tool tool = core::named<core::Tool>(name).value_or(m_present.tool);
        if (tool != m_present.tool && !m_window->brush()->isOffered(tool))
            continue;
        tools.append({tool, m_window->action(QStringLiteral("tool.") +
                                             QLatin1StringView(name.data(), static_cast<qsizetype>(name.size())))});
    }
    return tools;
}

void StrokeEdit::requestBrush(const core::BrushChange& brush)
{
    m_requested = brush;
    if (m_isReplacing && m_sinceBegin.elapsed() > maxReplaceMs)
        m_stop.request_stop();
    proceed();
}

void StrokeEdit::accept()
{
    m_isClosing = true;
    proceed();
}

void StrokeEdit::cancel()
{
    if (!m_stroke)
        return;
    m_isClosing = true;
    m_requested = core::brushOf(m_stroke->report.stroke()->settings);
    m_stop.request_stop();
    proceed();
}

void StrokeEdit::proceed()
{
    if (!m_stroke || m_isReplacing)
        return;
    const auto requested = std::exchange(m_requested, std::nullopt);
    if (requested && *requested != m_present)
        replaceStroke(*requested);
    else if (m_isClosing)
        end();
}

void StrokeEdit::replaceStroke(const core::BrushChange& brush)
{
    m_present = brush;
    m_isReplacing = true;
    m_sinceBegin.start();
    m_stop = std::stop_source();
    if (m_bar)
        m_bar->setHint({});
    const core::Stroke& before = *m_stroke->report.stroke();
    const bool isUnchanged = brush == core::brushOf(before.settings);
    m_document->lastStroke().replace(
        *m_stroke, isUnchanged ? nullptr : std::make_shared<const core::Stroke>(core::changed(before, brush)),
        m_stop.get_token(), [this](const std::optional<StrokeReport>& report) { onReplaced(report); });
}

void StrokeEdit::onReplaced(const std::optional<StrokeReport>& report)
{
    m_isReplacing = false;
    if (!report || !m_stroke)
        return end();
    m_index = m_document->history().stack().index();
    if (report->delta)
        m_present = core::brushOf(report->stroke()->settings); // the replacement may have been stopped
    else if (m_bar)
        m_bar->setHint(tr("With this brush it does nothing."));
    proceed();
}

/// Ends the edit when the next stroke begins, and applies a pending change first.
void StrokeEdit::finish()
{
    if (m_stroke && m_requested && *m_requested != m_present)
        replaceStroke(*m_requested);
    end();
}

/// Ends the edit if something else changed the history.
void StrokeEdit::checkHistory()
{
    if (m_stroke && !m_isReplacing && m_document->history().stack().index() != m_index)
        end();
}

void StrokeEdit::end()
{
    m_stroke.reset();
    m_requested.reset();
    if (m_bar)
        m_bar->dismiss();
    m_bar = nullptr;
}
} // namespace app
