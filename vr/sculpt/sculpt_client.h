#pragma once

#include "vr/frame/frame_client.h"
#include "vr/input/bare_hand.h"
#include "vr/input/wand_mapping.h"
#include "vr/panels/panel_manager.h"
#include "vr/scene/eye_target.h"
#include "vr/scene/scene.h"
#include "vr/scene/wand_labels.h"
#include "vr/sculpt/panel_contents.h"
#include "vr/sculpt/part_hand.h"
#include "vr/sculpt/tube_drawing.h"
#include "vr/sculpt/wand_brush.h"

#include <memory>

namespace vr
{
/// Sculpting in the headset: connects wands, brush, panels and scene with the document. Each visit has its own client.
///
/// Thread: the headset's, except for the constructor.
class SculptClient : public FrameClient
{
public:
    SculptClient(std::shared_ptr<DocumentPort> port, const HeadsetSettings& settings);
    ~SculptClient() override;

    bool create(QOpenGLContext& context) override;
    FrameOutput frame(const FrameInput& received) override;
    void draw(std::size_t eye, const EyeImage& image, const EyeView& view) override;
    void idle() override;
    double drawCallMs() const override { return m_scene.drawCallMs() + m_target.drawCallMs(); }
    void destroy() override;

private:
    void takeUpdate();
    void handleRoomChange(const FrameInput& input);
    void place(const FrameInput& input);
    void aimAtPanels(const FrameInput& input);
    bool pointsAtPanel(Side side) const;
    void handle(const std::vector<WandCommand>& commands);
    void handle(const WandCommand& command);
    void handle(Side side, const PanelAction& action);
    void applySettings(const HeadsetSettings& settings);
    HapticInput& hapticInput(Side side) { return m_hapticInputs[static_cast<std::size_t>(side)]; }
    void updateHaptics();
    void updateScene(const FrameInput& input);

    std::shared_ptr<DocumentPort> m_port;
    HeadsetSettings m_settings;
    DocumentUpdate m_update;
    std::array<BareHandReader, sideCount> m_bareHands{BareHandReader(Side::Left), BareHandReader(Side::Right)};
    WandMapping m_mapping;
    WandBrush m_brush;
    PartHand m_partHand;
    TubeDrawing m_tube;
    std::optional<Pose> m_tip; ///< tip of the sculpting wand, room space; none while the wand is not tracked
    Haptics m_haptics;
    std::array<HapticInput, sideCount> m_hapticInputs; ///< input of the present frame, indexed by Side
    WandLabels m_labels;
    ModelPlacement m_placement;
    bool m_isPlaced = false;
    Pose m_head;          ///< last known pose of the head, room space
    FrameOutput m_output; ///< output of the present frame

    PanelManager m_panels;
    PanelContents m_contents;

    Scene m_scene;
    EyeTarget m_target;
    SceneState m_state;
    std::shared_ptr<const core::Footprint> m_tint; ///< vertices that are marked in the scene
};
} // namespace vr
