#pragma once

#include "vr/input/wand_mapping.h"
#include "vr/scene/scene_state.h"

#include <cstdint>
#include <span>

namespace vr
{
// Times are in seconds, angles in degrees.
inline constexpr double labelFadeOut = 1, labelFadeIn = 0.3;
inline constexpr double labelLookSeconds = 0.5; ///< seconds that a wand must be looked at before its labels return
/// Angles between the direction of view and a wand, degrees. Below the first the user begins to look at the wand; above
/// the second the user no longer does.
inline constexpr double labelLookAngle = 12, labelLookAwayAngle = 16;
/// Angles between two wands as the head sees them, degrees. If they are farther apart, sideways or vertically, there is
/// room for the labels of both.
inline constexpr double minLabelGapAside = 30, minLabelGapAbove = 14;
/// Hysteresis of the decision whether both wands have room, so that labels do not flicker when hands tremble: degrees
/// for the angles, metres for the difference of the distances from the head.
inline constexpr double labelGapSlack = 3, labelGapSlackMetres = 0.03;

/// Texts and opacities of the labels at both wands' buttons, from the rows of the preset.
///
/// A label is shown until its function was used once, or both functions of a button that has two. After that it returns
/// while the wand is looked at. A wand that draws does not count as looked at, because the user looks at the clay. A
/// wand that points at a panel has no labels, which would hide the panel. If there is no room for the labels of both
/// wands, the farther wand has none. A wand that lacks a part has no label for it. After a change of the preset, or of
/// the hands' roles, all functions count as unused.
///
/// Uses no clock except the frames' times. Allocates only in a step that finds new settings, another task or another
/// kind of wand.
/// Thread: any.
class WandLabels
{
public:
    /// Updates the labels for a frame. To be called after WandMapping::step(), with that mapping as `hands` and with
    /// the commands that it returned.
    void step(const InputFrame& frame, const Pose& head, const WandMapping& hands,
              std::span<const WandCommand> commands);

    /// Returns the labels of a wand, indexed by WandSpot.
    std::array<WandLabel, wandSpotCount> labels(Side side) const;

private:
    /// The text at one spot.
    struct Line
    {
        QString text;
        std::uint64_t rows = 0; ///< functions that the text names, by their bits (bitOf())
    };
    using Lines = std::array<Line, wandSpotCount>;

    /// Parts that a wand has, as in WandState.
    struct WandKind
    {
        bool isStick = false, isSimple = false, isHand = false;
        bool operator==(const WandKind&) const = default;
    };

    struct Hand
    {
        std::array<Lines, handModeCount> linesOf; ///< indexed by HandMode
        WandKind kind;                            ///< kind of wand that the lines were written for
        HandMode mode = HandMode::Plain;
        std::array<float, wandSpotCount> opacities{};
        bool isNear = false; ///< the wand was near the direction of view in the last frame
        double nearFor = 0;  ///< seconds that the wand has been near the direction of view

        bool look(double degrees, double seconds);
        bool isSeen() const;
        void restart(const Lines& before);
        const Lines& lines() const { return linesOf[static_cast<std::size_t>(mode)]; }
    };

    void begin(const WandMapping& hands);
    void write(Hand& hand, HandRole role) const;
    void updateTask(const WandMapping& hands);
    void updateKinds(const InputFrame& frame, const WandMapping& hands);
    void note(const WandMapping& hands, std::span<const WandCommand> commands);
    void use(const WandMapping& hands, Side side, Gesture gesture);
    static void setMode(Hand& hand, HandMode mode);
    void fade(Hand& hand, bool isLookedAt, double seconds);
    static void hide(Hand& hand, double seconds);
    std::optional<Side> behind(const InputFrame& frame, const Pose& head) const;

    Hand& at(Side side) { return m_hands[static_cast<std::size_t>(side)]; }
    const Hand& at(Side side) const { return m_hands[static_cast<std::size_t>(side)]; }

    FrameClock m_clock;
    std::optional<WandSettings> m_settings; ///< settings that the lines were written for
    std::array<Hand, sideCount> m_hands;    ///< indexed by Side
    HandTask m_task = HandTask::Sculpt;     ///< task that the lines were written for
    std::uint64_t m_used = 0;               ///< functions used already, by their bits (bitOf())
    std::optional<Side> m_behind;           ///< wand for whose labels there is no room
};
} // namespace vr
