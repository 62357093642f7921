#pragma once

#include "vr/frame/frame_timing.h"
#include "vr/panels/panel_manager.h"
#include "vr/sculpt/brush_state.h"
#include "vr/sculpt/document_port.h"

namespace vr
{
/// Fills the panels of a visit. Stores what only the headset knows: current pages, the chosen file, the age of a
/// notice. Thread: the headset's.
class PanelContents
{
public:
    struct Sources
    {
        const DocumentUpdate& document;
        const HeadsetSettings& settings;
        const BrushState& brush;
        int channel; ///< WandMapping::channel()
        const FrameTimings& timings;
        double time;                    ///< seconds
        bool offersPassthrough = false; ///< see FrameInput
    };

    /// Takes over changes of the document. A new step of a lesson begins at its first page.
    void update(const DocumentUpdate& before, const DocumentUpdate& now);
    /// Turns pages and chooses files. Other actions change nothing.
    void apply(const PanelAction& action);
    /// Shows the contents of all open panels. Opens and closes the performance, lesson and notice panels, as settings
    /// and document require. To be called once a frame.
    void show(PanelManager& panels, const Sources& sources);
    const PartsPanel& parts() const { return m_parts; }

private:
    void showPerformance(PanelManager& panels, const Sources& sources);
    void showLesson(PanelManager& panels, const std::optional<LessonPanel>& lesson) const;
    void showNotice(PanelManager& panels, const Sources& sources);

    FilesPanel m_files;
    PartsPanel m_parts;
    int m_lessonPage = 0;
    SettingsPage m_settingsPage = SettingsPage::General;
    PerformancePanel m_performance;
    double m_measuredAt = 0; ///< time of the last measurement, seconds
    NoticePanel m_notice;
    quint64 m_noticeCount = 0; ///< DocumentUpdate::noticeCount of m_notice
    double m_noticedAt = 0;    ///< time at which m_notice was received, seconds
};
} // namespace vr
