#pragma once

#include "vr/input/wand_commands.h"
#include "vr/input/wand_gestures.h"

#include <vector>

namespace vr
{
/// Returns the tip of a wand, which is the brush's centre or the origin of its ray: tipReach from the palm in the
/// direction of aim. It is measured from the palm, because runtimes differ in the origin of the aim pose. The tip of a
/// bare hand is where thumb and index finger meet.
Pose tipOf(const WandState& wand);

inline constexpr double turnSpeed = 60;       ///< degrees a second, as fast as the desktop's turntable
inline constexpr double maxTrackingGap = 0.1; ///< seconds; a wand that is not tracked for longer ends its stroke
/// Slide that doubles the size of the model or of the brush, radii of the pad.
inline constexpr double slidePerDoubling = 1;
/// Change of a colour channel, 0 to 255, for a slide by one radius of the pad. The whole height of the pad covers half
/// of the channel's range, so that a thumb can change the value by 1.
inline constexpr double channelSlide = 255.0 / 4;

struct InputFrame
{
    double time = 0; ///< predicted display time, seconds
    Wands wands;
    std::array<bool, sideCount> pointsAtPanel{}; ///< indexed by Side
};

struct WandSettings
{
    ButtonPreset preset = ButtonPreset::Paper;
    Side sculpting = Side::Right;

    bool operator==(const WandSettings&) const = default;
};

/// Maps the gestures of both wands to commands, frame by frame. It uses no clock except the times of the frames.
/// Thread: any.
///
/// A trigger that is pulled while its wand points at a panel belongs to the panel until it is released. Otherwise, if
/// its hand sculpts, it begins a stroke at the wand's tip in the same frame; only one stroke is open at a time. While a
/// hand draws, its other buttons are ignored, because a tight grip presses them by accident. While a stroke is open,
/// undo, redo, save and restore are refused. In a frame's list, movements of the model by the other hand come before
/// the stroke's point.
///
/// A hand that puts its wand down, or takes one up, ends what it does; the new device has to be seen released first.
///
/// Stroke points have the frame rate. Core spaces the dabs evenly along their path (StrokeSettings::spacing).
class WandMapping
{
public:
    explicit WandMapping(const WandSettings& settings = {}) : m_settings(settings) {}

    const WandSettings& settings() const { return m_settings; }
    /// Changes the settings. Returns the commands that end all actions in progress, as releaseAll() does.
    std::vector<WandCommand> setSettings(const WandSettings& settings);

    std::vector<WandCommand> step(const InputFrame& frame);
    /// Returns the commands that end all actions in progress. Buttons that are down have no effect until they were
    /// released. Panels remain open or closed.
    std::vector<WandCommand> releaseAll();

    HandRole roleOf(Side side) const;
    /// Returns the mode of a hand. Plain: its panel is closed.
    HandMode modeOf(Side side) const;
    /// Opens or closes the tool menu without a button, for example because another panel replaces it.
    void setToolMenuOpen(bool isOpen) { m_toolMenuOpen = isOpen; }
    HandTask task() const { return m_task; }
    /// Sets the task of the sculpting hand. A stroke in progress goes on until its trigger is released.
    void setTask(HandTask task) { m_task = task; }
    /// Returns the selected colour channel: 0 red, 1 green, 2 blue.
    int channel() const { return m_channel; }
    void selectChannel(int channel) { m_channel = channel; }
    bool isDrawing(Side side) const { return m_stroke && m_stroke->side == side; }
    /// Returns the hand's gestures in the last frame.
    const WandGestures& gestures(Side side) const { return at(side).gestures; }

    /// A hold in progress, which is shown as a ring that fills.
    struct Hold
    {
        Gesture gesture;
        double progress; ///< fraction of holdSeconds that has passed, above 0, at most 1
    };
    /// Returns the hold in progress; none unless the hand holds a button whose hold has a function.
    std::optional<Hold> hold(Side side) const;

private:
    enum class TriggerUse { None, Panel, Function };

    struct Hand
    {
        GestureReader reader;
        WandGestures gestures;
        bool isBare = false; ///< the hand holds no wand
        TriggerUse trigger = TriggerUse::None;
        std::optional<Pose> grip; ///< pose in the last frame, room space; none: the hand does not grab the model
    };

    struct OpenStroke
    {
        Side side;
        double seenAt; ///< time at which the wand was last tracked, seconds
        bool isBegun = false;
        bool smooths = false;
        bool continues = false;
    };

    Hand& at(Side side) { return m_hands[static_cast<std::size_t>(side)]; }
    const Hand& at(Side side) const { return m_hands[static_cast<std::size_t>(side)]; }
    std::array<Side, sideCount> order() const;
    std::optional<WandFunction> functionOf(Side side, Gesture gesture) const;
    void addCommand(Side side, Gesture gesture, const WandAction& action);

    void releaseHand(Side side);
    void endStroke();
    void endFinishedStroke(const InputFrame& frame);
    void updateTrigger(Side side, const InputFrame& frame);
    void pressTrigger(Side side, const InputFrame& frame);
    void updateButtons(Side side, double seconds);
    void press(Side side, Gesture gesture);
    void holdButton(Side side, Gesture gesture, double seconds);
    void slide(Side side, Gesture gesture, double by);
    void changeChannel(Side side, Gesture gesture, double by);
    bool usesTrigger(Side side, WandFunction function) const;
    bool isGrabbing(Side side) const;
    void updateGrabs(const InputFrame& frame);
    void updateHeldPart(const InputFrame& frame);
    void releasePart();
    void updateStroke(const InputFrame& frame);

    WandSettings m_settings;
    FrameClock m_clock;
    std::array<Hand, sideCount> m_hands;
    bool m_toolMenuOpen = false, m_colorPanelOpen = false;
    HandTask m_task = HandTask::Sculpt;
    int m_channel = 0;
    double m_channelRemainder = 0; ///< part of a slide that is less than a step of 1, kept for the next frame
    std::optional<OpenStroke> m_stroke;
    std::optional<Pose>
        m_partGrip; ///< pose of the hand that moves a part, in the last frame, room space; none: no part
    std::vector<WandCommand> m_commands; ///< commands of the present frame
};
} // namespace vr
