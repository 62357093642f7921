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

/// What a hand does with the wand's buttons.
struct SimulatedButtons
{
    double trigger = 0; ///< 0 to 1
    /// The thumb, where it touches: x right, y away from the hand, at most 1 from the middle.
    Eigen::Vector2d pad = Eigen::Vector2d::Zero();
    bool touchesPad = false, pressesPad = false;
    bool squeezes = false, pressesMenu = false;

    bool operator==(const SimulatedButtons&) const = default;
};

/// The simulated user's pose, controlled by mouse and keys: a head that turns and walks, the hand that follows the
/// mouse, and the other hand, which rests in front of the body. Room space: metres, Y up, the floor at y = 0; what
/// points, points along its own -Z.
class SimulatorControls
{
public:
    /// How far the eye sees, as tangents: to both sides, and up and down.
    static constexpr double sideTangent = 1.125, upTangent = 1;

    SimulatorControls();

    Eigen::Isometry3d head() const;
    /// A wand's front end.
    Eigen::Isometry3d tip(SimulatedHand hand) const;
    SimulatedButtons& buttons(SimulatedHand hand) { return m_buttons[static_cast<std::size_t>(hand)]; }
    const SimulatedButtons& buttons(SimulatedHand hand) const { return m_buttons[static_cast<std::size_t>(hand)]; }

    /// The one that follows the mouse.
    SimulatedHand hand() const { return m_hand; }
    /// The hand used so far returns to its rest pose; if it holds something, it stays.
    void swapHands();

    /// Radians to the left and up.
    void turnHead(double left, double up);
    /// To the right, up and back as the head faces, along the floor; as far as the room goes.
    void walk(const core::Vec3& metres);
    /// Where the mouse is in what the eye sees, of which there is one: -1 to 1, right and up.
    void pointAt(const Eigen::Vector2d& place);
    /// Returns the ray from the eye through where the mouse is.
    core::Ray sight() const;
    /// Surface under the mouse.
    struct Surface
    {
        double distance = 0; ///< metres from the eye
        bool isPanel = false;
    };
    /// Way in which the wand goes along with what is under the mouse.
    enum class Following {
        Freely,
        WithTheMouse, ///< while it presses: on what it began, and no faster than the mouse moves, or what grows below
                      ///< a resting wand would drive it on
        Not
    };
    /// Puts the wand's tip to the surface under the mouse, or as far before or behind it as reach() has brought it.
    /// Without one it stays as far from the eye as it is. At a panel, and for a ray brush, the tip stays short of that
    /// place and points at it.
    void meet(const std::optional<Surface>& surface, Following following, bool isRay);
    /// The wand goes farther along the eye's way to it.
    void reach(double metres);
    /// Metres of the tip behind the surface under the mouse; nothing where none is, or the wand points from afar.
    std::optional<double> depth() const;
    /// The wand turns about the way that it points; radians, anticlockwise as seen from the hand.
    void turn(double angle) { m_turn += angle; }

private:
    static constexpr double standingEyeHeight = 1.6, initialReach = 0.36;
    static constexpr double initialPitch = -0.26; ///< radians: models are placed below the eyes

    Eigen::Isometry3d body() const;
    core::Vec3 way() const;
    Eigen::Isometry3d atMouse() const;

    core::Vec3 m_position{0, standingEyeHeight, 0}; ///< of the head
    double m_yaw = 0, m_pitch = initialPitch;
    SimulatedHand m_hand = SimulatedHand::Right;
    Eigen::Vector2d m_place{0.3, -0.3}; ///< beside the model
    double m_reach = initialReach;      ///< from the eye to the tip, or to the place at which it points
    double m_offset = 0;                ///< metres behind the surface that reach() has chosen
    std::optional<Surface> m_surface;
    bool m_pointsFromAfar = false;
    core::Vec3 m_lastWay = -core::Vec3::UnitZ(); ///< room space: of the last meet()
    double m_turn = 0;
    std::array<SimulatedButtons, simulatedHandCount> m_buttons;
    Eigen::Isometry3d m_restingWand; ///< the other hand's wand, as seen from the body
};
} // namespace ui
