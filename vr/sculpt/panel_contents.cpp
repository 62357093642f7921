#include "vr/sculpt/panel_contents.h"

#include "core/util/overloaded.h"

#include <cmath>

namespace vr
{
namespace
{
constexpr double measuringInterval = 0.5; ///< seconds between updates; numbers that change faster cannot be read

bool isSameStep(const std::optional<LessonPanel>& a, const std::optional<LessonPanel>& b)
{
    return a && b && a->lesson == b->lesson && a->step == b->step;
}

ToolPanel toolPanel(const PanelContents::Sources& sources)
{
    const core::StrokeSettings& stroke = sources.brush.stroke;
    return {stroke.tool,
            stroke.brush,
            std::round(sources.brush.radius * 1e4) / 1e4, // tenths of a millimetre: each change is a new picture
            stroke.topology,
            stroke.symmetry != core::Symmetry::None,
            stroke.radial,
            sources.brush.isInverse,
            sources.brush.addsNext,
            sources.document.canUndo,
            sources.document.canRedo,
            !sources.document.isBusy};
}
} // namespace

void PanelContents::update(const DocumentUpdate& before, const DocumentUpdate& now)
{
    if (!isSameStep(now.lesson, before.lesson))
        m_lessonPage = 0;
    m_files.folder = now.folder;
    m_files.files = now.files;
    m_files.hasUnsavedChanges = now.isModified;
    m_files.isBusy = now.isBusy;
    m_files.saved = now.saved;
    m_parts.parts = now.parts;
    m_parts.active = now.activePart;
    m_parts.canUndo = now.canUndo;
    m_parts.canRedo = now.canRedo;
    m_parts.isBusy = now.isBusy;
    m_parts.preview = now.preview;
    if (now.preview && !before.preview)
        m_parts.shown = PartsPage::List; // with the buttons that end the preview
}

void PanelContents::apply(const PanelAction& action)
{
    const core::Overloaded handler{
        [&](SettingsPage page) { m_settingsPage = page; },
        [&](const ShowLessonPage& shown) { m_lessonPage = shown.page; },
        [](const auto&) {},
    };
    std::visit(handler, action);
    m_files = m_files.after(action);
    m_parts = m_parts.after(action);
}

void PanelContents::show(PanelManager& panels, const Sources& sources)
{
    if (panels.isOpen(PanelKind::Tools))
        panels.show(toolPanel(sources));
    if (panels.isOpen(PanelKind::Color))
        panels.show(ColorPanel{sources.brush.stroke.color, sources.channel, sources.document.swatches});
    if (panels.isOpen(PanelKind::Files))
        panels.show(m_files);
    if (panels.isOpen(PanelKind::Parts))
        panels.show(m_parts);
    if (panels.isOpen(PanelKind::Settings))
        panels.show(SettingsPanel{m_settingsPage, sources.settings, sources.offersPassthrough});
    showPerformance(panels, sources);
    showLesson(panels, sources.document.lesson);
    showNotice(panels, sources);
}

void PanelContents::showPerformance(PanelManager& panels, const Sources& sources)
{
    panels.open(PanelKind::Performance, sources.settings.showsPerformance);
    if (!sources.settings.showsPerformance)
        return;
    if (std::abs(sources.time - m_measuredAt) >= measuringInterval) {
        m_performance = PerformancePanel::of(sources.timings.recent(), sources.timings.droppedFrames());
        m_measuredAt = sources.time;
    }
    panels.show(m_performance);
}

/// Shows the page of an open lesson, unless the files or parts panel is open in its place.
void PanelContents::showLesson(PanelManager& panels, const std::optional<LessonPanel>& lesson) const
{
    const bool isShown = lesson && !panels.isOpen(PanelKind::Files) && !panels.isOpen(PanelKind::Parts);
    panels.open(PanelKind::Lesson, isShown);
    if (!isShown)
        return;
    LessonPanel panel = *lesson;
    panel.page = m_lessonPage;
    panels.show(panel);
}

void PanelContents::showNotice(PanelManager& panels, const Sources& sources)
{
    if (sources.document.noticeCount != m_noticeCount) {
        m_noticeCount = sources.document.noticeCount;
        m_notice.text = sources.document.notice;
        m_noticedAt = sources.time;
        panels.open(PanelKind::Notice, false); // closed first, so that it opens again where the user looks now
        panels.open(PanelKind::Notice);
    }
    if (!panels.isOpen(PanelKind::Notice))
        return;
    const double opacity = noticeOpacity(m_notice, sources.time - m_noticedAt);
    panels.show(m_notice, static_cast<float>(opacity));
    if (sources.time > m_noticedAt && opacity == 0)
        panels.open(PanelKind::Notice, false);
}
} // namespace vr
