#pragma once

#include "vr/input/wand_commands.h"
#include "vr/input/wand_gestures.h"

#include <vector>

namespace vr
{
/// The brush's centre, or where its ray begins: so far before the palm along the aim as the wand is long. From the
/// palm, because runtimes put the aim's own origin where they like.
Pose tipOf(const WandState& wand);

inline constexpr double turnSpeed = 60;       ///< degrees a second, as the desktop's turntable
inline constexpr double maxTrackingGap = 0.1; ///< seconds; a wand unseen for longer ends its stroke
inline constexpr double slidePerDoubling = 1; ///< radii of the pad that double the model's size, or the brush's
/// Of a colour channel, for a radius of the pad: its whole height is half the channel's range, which leaves a thumb its
/// finest steps.
inline constexpr double channelSlide = 255.0 / 4;

struct InputFrame
{
    double time = 0; ///< seconds; of the predicted display
    Wands wands;
    std::array<bool, sideCount> pointsAtPanel{}; ///< by Side
};

struct WandSettings
{
    ButtonPreset preset = ButtonPreset::Paper;
    Side sculpting = Side::Right;

    bool operator==(const WandSettings&) const = default;
};

/// Maps the gestures of both wands to commands, frame by frame. Pure: any thread, no clock but the frames' own.
///
/// A trigger that is pulled while its wand points at a panel is the panel's until it is let go. Else it begins a
/// stroke, at the wand's tip in that same frame, if its hand sculpts; one stroke is open at a time. While a hand draws,
/// nothing else of it counts: squeezing a wand fires its other buttons. While a stroke is open, nothing is undone,
/// redone, saved or restored. What the other hand does to the view comes, in a frame's list, before the stroke's point.
///
/// Points come as the frames fall: to stand the dabs evenly along their path is core's (StrokeSettings::spacing).
class WandMapping
{
public:
    explicit WandMapping(const WandSettings& settings = {}) : m_settings(settings) {}

    const WandSettings& settings() const { return m_settings; }
    /// What goes on ends, as by releaseAll().
    std::vector<WandCommand> setSettings(const WandSettings& settings);

    std::vector<WandCommand> step(const InputFrame& frame);
    /// Ends what goes on; what is pressed does nothing until it has been let go. Panels stay as they are.
    std::vector<WandCommand> releaseAll();

    HandRole roleOf(Side side) const;
    /// Plain: its panel is closed.
    HandMode modeOf(Side side) const;
    /// Opens or closes it without a button, for a panel that takes its place.
    void setToolMenuOpen(bool isOpen) { m_toolMenuOpen = isOpen; }
    /// 0 red, 1 green, 2 blue.
    int channel() const { return m_channel; }
    void selectChannel(int channel) { m_channel = channel; }
    bool isDrawing(Side side) const { return m_stroke && m_stroke->side == side; }
    /// In the last frame.
    const WandGestures& gestures(Side side) const { return at(side).gestures; }

    /// A ring that fills.
    struct Hold
    {
        Gesture gesture;
        double progress; ///< above 0, to 1
    };
    /// Nothing if the hand holds no button that a hold does anything with.
    std::optional<Hold> hold(Side side) const;

private:
    enum class TriggerUse { None, Panel, Function };

    struct Hand
    {
        GestureReader reader;
        WandGestures gestures;
        TriggerUse trigger = TriggerUse::None;
        std::optional<Pose> grip; ///< while it grabs the model
    };

    struct OpenStroke
    {
        Side side;
        double seenAt; ///< the wand, last
        bool isBegun = false;
        bool smooths = false;
        bool continues = false;
    };

    Hand& at(Side side) { return m_hands[static_cast<std::size_t>(side)]; }
    const Hand& at(Side side) const { return m_hands[static_cast<std::size_t>(side)]; }
    std::array<Side, sideCount> order() const;
    std::optional<WandFunction> functionOf(Side side, Gesture gesture) const;
    void addCommand(Side side, Gesture gesture, const WandAction& action);

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
    void updateStroke(const InputFrame& frame);

    WandSettings m_settings;
    FrameClock m_clock;
    std::array<Hand, sideCount> m_hands;
    bool m_toolMenuOpen = false, m_colorPanelOpen = false;
    int m_channel = 0;
    double m_channelRemainder = 0; ///< slid, but less than one
    std::optional<OpenStroke> m_stroke;
    std::vector<WandCommand> m_commands; ///< of the frame
};
} // namespace vr
