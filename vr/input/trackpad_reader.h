#pragma once

#include "vr/openxr/wand_state.h"

#include <optional>

namespace vr
{
/// Where a pad is pressed, or to where a stick is pushed; Top is away from the hand.
enum class Sector { Left, Right, Top, Bottom };

// Lengths on a pad are in its radii.
/// A thumb that rests or presses rolls as far: about 2 mm on a Vive wand.
inline constexpr double slideThreshold = 0.12;
/// Seconds; a slide that was so short when a press came was the way to it.
inline constexpr double maxSlideBeforePress = 0.6;
inline constexpr double padCentre = 0.35;           ///< the dead centre, for a thumb that comes from there
inline constexpr double padCentreHysteresis = 0.25; ///< the dead centre for a thumb that comes from a sector
inline constexpr double sectorOverlap = 8;          ///< degrees that a sector keeps a thumb beyond its edge
inline constexpr double stickPress = 0.7, stickRelease = 0.5;
inline constexpr double stickDeadZone = 0.2; ///< of a clicked stick: it slides only beyond this
inline constexpr double stickSlide = 1.5;    ///< radii a second that a clicked stick slides at its end

/// What a thumb does on a pad, or with a stick, in one frame.
struct TrackpadGestures
{
    std::optional<Sector> over;    ///< what a press would mean where the thumb is
    std::optional<Sector> pressed; ///< a press began in this frame
    std::optional<Sector> held;    ///< a press goes on: the sector where it began, wherever the thumb is by now
    /// Since the frame before, in radii. It goes along one axis, which its beginning decides; the other component is 0.
    Eigen::Vector2d slide = Eigen::Vector2d::Zero();
};

/// Reads the pad or the stick of one wand. A press in the dead centre is none. A slide is a thumb that moves without
/// pressing: it begins past the threshold, from there; a press ends it, and where a thumb comes down or lifts is no
/// part of it. What turns out to have been a thumb on its way to press is slid back in the frame of the press. A pushed
/// stick is a press; a clicked one slides at a rate.
class TrackpadReader
{
public:
    /// `seconds`: since the frame before.
    TrackpadGestures read(const WandState& wand, double seconds);
    /// What goes on ends here; what is pressed does nothing until it has been let go.
    void ignoreUntilReleased();

private:
    void readPad(const WandState& wand, double seconds, TrackpadGestures& gestures);
    void readStick(const WandState& wand, double seconds, TrackpadGestures& gestures);
    bool isValidSample(const Eigen::Vector2d& position);
    Eigen::Vector2d slideTo(const Eigen::Vector2d& position, double seconds);
    Eigen::Vector2d undoSlide();
    double stickSlid(const WandState& wand, double seconds);

    bool m_isIgnored = false; ///< until it has been let go
    bool m_isDown = false;
    std::optional<Sector> m_press; ///< while it is down; none if that began in the dead centre
    std::optional<Sector> m_over;
    bool m_wasZero = false;
    std::optional<Eigen::Vector2d> m_slidTo;          ///< where the thumb was
    std::optional<Eigen::Index> m_slideAxis;          ///< once it slides
    Eigen::Vector2d m_slid = Eigen::Vector2d::Zero(); ///< since the slide began
    double m_slideAge = 0;                            ///< seconds
    std::optional<double> m_stickRate;                ///< of a clicked stick, in the frame before
    bool m_mustCentre = false; ///< the stick was clicked: no press until it has been in the middle
};
} // namespace vr
