#pragma once

#include "vr/input/wand_mapping.h"
#include "vr/scene/scene_state.h"

#include <cstdint>
#include <span>

namespace vr
{
// Seconds and degrees.
inline constexpr double labelFadeOut = 1, labelFadeIn = 0.3;
inline constexpr double labelLookSeconds = 0.5; ///< a wand has to be looked at for so long
/// Between where the head looks and the wand: labels come back below the first, and go again above the second.
inline constexpr double labelLookAngle = 12, labelLookAwayAngle = 16;
/// Between two wands as the head sees them: farther apart, beside each other or above, the labels of both have room.
inline constexpr double minLabelGapAside = 30, minLabelGapAbove = 14;
/// So much farther apart they have to be when there was none, so that hands may tremble; metres are of their distances
/// from the head.
inline constexpr double labelGapSlack = 3, labelGapSlackMetres = 0.03;

/// What the labels at both wands' buttons say, and how well they are seen: the rows of the preset. A label is there
/// until what it tells of was done once, all of it where a button has two functions; then it comes back while the wand
/// is looked at. A wand that draws is not: it is the clay that is looked at. One that points at a panel has none, which
/// would stand before what it points at; nor has the farther of two wands between which there is no room for the labels
/// of both. A wand that lacks a part has no label there. With another preset, or other hands, all of them are new.
///
/// Pure: any thread, no clock but the frames' own. Allocates nothing but in the step that finds another choice.
class WandLabels
{
public:
    /// Of each frame, after WandMapping::step(): `hands` as it is then, and the commands that it gave.
    void step(const InputFrame& frame, const Pose& head, const WandMapping& hands,
              std::span<const WandCommand> commands);

    /// By WandSpot.
    std::array<WandLabel, wandSpotCount> labels(Side side) const;

private:
    /// What is at one spot.
    struct Line
    {
        QString text;
        std::uint32_t rows = 0; ///< bit i: row i of the preset
    };
    using Lines = std::array<Line, wandSpotCount>;

    /// Parts that a wand is made of, as WandState has them.
    struct WandKind
    {
        bool isStick = false, isSimple = false;
        bool operator==(const WandKind&) const = default;
    };

    struct Hand
    {
        std::array<Lines, handModeCount> linesOf; ///< by HandMode
        WandKind kind;                            ///< that the lines are of
        HandMode mode = HandMode::Plain;
        std::array<float, wandSpotCount> opacities{};
        bool isNear = false; ///< to where the head looks, in the last frame
        double nearFor = 0;  ///< seconds

        bool look(double degrees, double seconds);
        bool isSeen() const;
        const Lines& lines() const { return linesOf[static_cast<std::size_t>(mode)]; }
    };

    void begin(const WandMapping& hands);
    void write(Hand& hand, HandRole role) const;
    void updateKinds(const InputFrame& frame, const WandMapping& hands);
    void note(const WandMapping& hands, std::span<const WandCommand> commands);
    void use(const WandMapping& hands, Side side, Gesture gesture);
    void setMode(Hand& hand, HandMode mode);
    void fade(Hand& hand, bool isLookedAt, double seconds);
    static void hide(Hand& hand, double seconds);
    std::optional<Side> behind(const InputFrame& frame, const Pose& head) const;

    Hand& at(Side side) { return m_hands[static_cast<std::size_t>(side)]; }
    const Hand& at(Side side) const { return m_hands[static_cast<std::size_t>(side)]; }

    FrameClock m_clock;
    std::optional<WandSettings> m_settings; ///< that the lines are of
    std::array<Hand, sideCount> m_hands;    ///< by Side
    std::uint32_t m_used = 0;               ///< rows
    std::optional<Side> m_behind;           ///< whose labels there is no room for
};
} // namespace vr
