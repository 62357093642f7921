#pragma once

#include "core/geometry/geometry.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>

namespace ui
{
enum class SimulatedHand { Left, Right };
inline constexpr std::size_t simulatedHandCount = 2;

/// State of a wand's buttons.
struct SimulatedButtons
{
    double trigger = 0; ///< 0 to 1
    /// Position of the thumb on the pad, within the unit circle: x right, y forwards.
    Eigen::Vector2d pad = Eigen::Vector2d::Zero();
    bool touchesPad = false, pressesPad = false;
    bool squeezes = false, pressesMenu = false;

    bool operator==(const SimulatedButtons&) const = default;
};

/// The pose of the simulated user, controlled by mouse and keys: a head that turns and walks, a hand that follows the
/// mouse, and another hand that rests in front of the body. Units: room space in metres, Y up, floor at y = 0. Wands
/// point along their -Z axis.
class SimulatorControls
{
public:
    /// Tangents of half the field of view: horizontal and vertical.
    static constexpr double sideTangent = 1.125, upTangent = 1;

    SimulatorControls();

    Eigen::Isometry3d head() const;
    /// Returns the pose of the front end of a hand's wand.
    Eigen::Isometry3d tip(SimulatedHand hand) const;
    SimulatedButtons& buttons(SimulatedHand hand) { return m_buttons[static_cast<std::size_t>(hand)]; }
    const SimulatedButtons& buttons(SimulatedHand hand) const { return m_buttons[static_cast<std::size_t>(hand)]; }

    /// Returns the hand that follows the mouse.
    SimulatedHand hand() const { return m_hand; }
    /// Lets the other hand follow the mouse. The previous hand returns to its rest pose, or stays in place if it holds
    /// the trigger or grip.
    void swapHands();

    /// Turns the head by angles in radians.
    void turnHead(double left, double up);
    /// Moves the head, within the room. `metres`: to the right, up and backwards relative to the body.
    void walk(const core::Vec3& metres);
    /// Sets the mouse's position in the picture of the eye: -1 to 1, right and up.
    void pointAt(const Eigen::Vector2d& place);
    /// Returns the ray from the eye through the mouse.
    core::Ray sight() const;
    /// The surface under the mouse.
    struct Surface
    {
        double distance = 0; ///< metres from the eye
        bool isPanel = false;
    };
    /// Ways in which the wand follows the surface under the mouse.
    enum class Following {
        Freely,
        /// While a button is pressed: on the kind of surface on which the press began, and no faster than the mouse
        /// moves. Otherwise material that grows under a resting wand would push the wand on.
        WithTheMouse,
        Not
    };
    /// Moves the wand's tip to the surface under the mouse, offset by the distance chosen with reach(). Without a
    /// surface, the distance from the eye stays unchanged. At panels, and with ray brushes, the tip stays short of the
    /// surface and points at it.
    void meet(const std::optional<Surface>& surface, Following following, bool isRay);
    /// Moves the wand farther away along the ray from the eye, by `metres`.
    void reach(double metres);
    /// Returns the distance of the tip behind the surface under the mouse, metres; nullopt without a surface, or if the
    /// wand points from a distance.
    std::optional<double> depth() const;
    /// Turns the wand about its axis; radians, anticlockwise as seen from the hand.
    void turn(double angle) { m_turn += angle; }

private:
    static constexpr double standingEyeHeight = 1.6, initialReach = 0.36;
    static constexpr double initialPitch = -0.26; ///< radians; downwards, because models are placed below the eyes

    Eigen::Isometry3d body() const;
    core::Vec3 way() const;
    Eigen::Isometry3d atMouse() const;

    core::Vec3 m_position{0, standingEyeHeight, 0}; ///< position of the head, room space
    double m_yaw = 0, m_pitch = initialPitch;
    SimulatedHand m_hand = SimulatedHand::Right;
    Eigen::Vector2d m_place{0.3, -0.3}; ///< initially beside the model
    double m_reach = initialReach;      ///< metres from the eye to the tip, or to the place it points at
    double m_offset = 0;                ///< metres behind the surface, chosen with reach()
    std::optional<Surface> m_surface;
    bool m_pointsFromAfar = false;
    core::Vec3 m_lastWay = -core::Vec3::UnitZ(); ///< direction through the mouse at the last meet(), room space
    double m_turn = 0;
    std::array<SimulatedButtons, simulatedHandCount> m_buttons;
    Eigen::Isometry3d m_restingWand; ///< pose of the other hand's wand, body space
};
} // namespace ui
