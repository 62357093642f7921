#pragma once

#include "vr/openxr/wand_state.h"

#include <optional>

namespace vr
{
/// The part of a pad that is pressed, or the direction of a pushed stick. Top is away from the palm.
enum class Sector { Left, Right, Top, Bottom };

// Lengths on a pad are multiples of its radius.
/// Largest movement of a thumb that does not slide, radii: a resting or pressing thumb rolls as far, about 2 mm on a
/// Vive wand.
inline constexpr double slideThreshold = 0.12;
/// Longest slide that a press undoes, seconds: the thumb was only on its way to the press.
inline constexpr double maxSlideBeforePress = 0.6;
inline constexpr double padCentre = 0.35; ///< radius of the dead centre while the thumb is in no sector, radii
inline constexpr double padCentreHysteresis = 0.25; ///< radius of the dead centre while the thumb is in a sector, radii
inline constexpr double sectorOverlap = 8;          ///< degrees that a sector is extended for a thumb that is in it
/// Pushing a stick counts as a press from the first deflection on, until it is below the second, 0 to 1.
inline constexpr double stickPress = 0.7, stickRelease = 0.5;
inline constexpr double stickDeadZone = 0.2; ///< a clicked stick slides only if it is pushed farther than this, 0 to 1
/// Speed of the slide when a clicked stick is pushed fully, radii a second.
inline constexpr double stickSlide = 1.5;

/// Gestures on a pad, or with a stick, in one frame.
struct TrackpadGestures
{
    std::optional<Sector> over;    ///< sector under the thumb, or of the pushed stick; none: centre or no touch
    std::optional<Sector> pressed; ///< sector of a press that began in this frame
    std::optional<Sector> held;    ///< sector where the present press began, wherever the thumb is by now
    /// Slide since the last frame, radii. It is along one axis, which the beginning of the slide determines; the other
    /// component is 0.
    Eigen::Vector2d slide = Eigen::Vector2d::Zero();
};

/// Reads the pad or the stick of one wand.
///
/// Pad: a press in the dead centre does nothing. A slide is a movement of the thumb without a press. It begins when the
/// thumb has moved by slideThreshold, and is measured from there. A press ends the slide, and undoes it if the slide
/// was short. Jumps of the position when the thumb touches down or lifts are ignored.
///
/// Stick: pushing it is a press. A stick that is clicked and pushed slides at a rate.
class TrackpadReader
{
public:
    /// Returns the gestures of a frame. `seconds`: time since the last frame.
    TrackpadGestures read(const WandState& wand, double seconds);
    /// Ends gestures in progress. A press has no effect until the pad or stick was released.
    void ignoreUntilReleased();

private:
    void readPad(const WandState& wand, double seconds, TrackpadGestures& gestures);
    void readStick(const WandState& wand, double seconds, TrackpadGestures& gestures);
    bool isValidSample(const Eigen::Vector2d& position);
    Eigen::Vector2d slideTo(const Eigen::Vector2d& position, double seconds);
    Eigen::Vector2d undoSlide();
    double stickSlid(const WandState& wand, double seconds);

    bool m_isIgnored = false; ///< presses have no effect until the pad or stick was released
    bool m_isDown = false;
    std::optional<Sector> m_press; ///< sector of the present press; none if it began in the dead centre
    std::optional<Sector> m_over;
    bool m_wasZero = false;
    /// Point where the thumb touched down, then last point of its slide, radii; none: no touch that can slide.
    std::optional<Eigen::Vector2d> m_slidTo;
    std::optional<Eigen::Index> m_slideAxis;          ///< axis of the slide; none: no slide has begun
    Eigen::Vector2d m_slid = Eigen::Vector2d::Zero(); ///< sum since the slide began, radii
    double m_slideAge = 0;                            ///< time since the slide began, seconds
    /// Rate of the slide by a clicked stick in the last frame, radii a second; none: the stick was not clicked.
    std::optional<double> m_stickRate;
    bool m_mustCentre = false; ///< the stick was clicked: pushing it is no press until it was centred
};
} // namespace vr
