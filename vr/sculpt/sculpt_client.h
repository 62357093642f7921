#pragma once

#include "vr/frame/frame_client.h"
#include "vr/input/wand_mapping.h"
#include "vr/panels/panel_manager.h"
#include "vr/scene/eye_target.h"
#include "vr/scene/scene.h"
#include "vr/scene/wand_labels.h"
#include "vr/sculpt/wand_brush.h"

#include <memory>

namespace vr
{
/// Sculpting in the headset: hands, brush, panels and the scene around the document's model, as one client. The order
/// of a frame is in frame(); what hands and panels ask for is done in sculpt_client_commands.cpp, what is seen is put
/// together in sculpt_client_view.cpp.
///
/// Each visit has its own, which is used on the headset's thread only, except the constructor.
class SculptClient : public FrameClient
{
public:
    SculptClient(std::shared_ptr<DocumentPort> port, const HeadsetSettings& settings);
    ~SculptClient() override;

    bool create(QOpenGLContext& context) override;
    FrameOutput frame(const FrameInput& input) override;
    void draw(std::size_t eye, const EyeImage& image, const EyeView& view) override;
    void idle() override;
    double drawCallMs() const override { return m_scene.drawCallMs() + m_target.drawCallMs(); }
    void destroy() override;

private:
    // The frame's steps.
    void takeUpdate();
    void takePatch();
    void handleRoomChange(const FrameInput& input);
    void place(const FrameInput& input);
    void aimAtPanels(const FrameInput& input);
    InputFrame inputFrame(const FrameInput& input) const;
    void updateHaptics();

    // What is asked for.
    void handle(const std::vector<WandCommand>& commands);
    void handle(const WandCommand& command);
    void handle(Side side, const PanelAction& action);
    void handleBrush(const PanelAction& action);
    void handle(PanelCommand command);
    void applySettings(const HeadsetSettings& settings);
    HapticInput& hapticInput(Side side) { return m_hapticInputs[static_cast<std::size_t>(side)]; }

    // What is seen.
    void showPanels(const FrameInput& input);
    ToolPanel toolPanel() const;
    void showNotice(double time);
    void showLesson();
    void updateScene(const FrameInput& input);
    ShownWand shown(const WandState& wand, Side side) const;
    void publishAvatar(const FrameInput& input);
    bool pointsAtPanel(Side side) const;

    std::shared_ptr<DocumentPort> m_port;
    HeadsetSettings m_settings;
    DocumentUpdate m_update;
    WandMapping m_mapping;
    WandBrush m_brush;
    std::optional<Pose> m_tip; ///< of the sculpting wand; nothing while that is not seen
    Haptics m_haptics;
    std::array<HapticInput, sideCount> m_hapticInputs; ///< of the frame, by Side
    WandLabels m_labels;
    ModelPlacement m_placement;
    bool m_isPlaced = false;
    Pose m_head;          ///< last known
    FrameOutput m_output; ///< of the frame

    PanelManager m_panels;
    FilesPanel m_files;
    int m_lessonPage = 0;
    SettingsPage m_page = SettingsPage::General;
    PerformancePanel m_performance;
    double m_measuredAt = 0; ///< seconds
    NoticePanel m_notice;
    quint64 m_noticeCount = 0; ///< DocumentUpdate::noticeCount of that
    double m_noticedAt = 0;    ///< seconds

    Scene m_scene;
    EyeTarget m_target;
    SceneState m_state;
    std::shared_ptr<const core::Footprint> m_tint; ///< that is shown
};
} // namespace vr
