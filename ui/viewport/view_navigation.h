#pragma once

#include "ui/input/pointer_input.h"
#include "ui/scene/headset_avatar.h"
#include "ui/scene/orbit_camera.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QVariantAnimation>

#include <optional>

namespace ui
{
/// Moves the view for commands, search results and the headset: at once, by an animated flight, or following the head
/// of the avatar. Thread: gui.
class ViewNavigation : public QObject
{
    Q_OBJECT

public:
    struct Mark
    {
        core::Vec3 point, normal;
        double radius;
    };

    /// Neither argument is owned. The input reports when the user moves the view, and is informed when this class moves
    /// it.
    ViewNavigation(OrbitCamera* camera, PointerInput* input, QObject* parent = nullptr);

    /// Frames a new model from the initial direction, and removes the mark.
    void showModel(const core::Box& box);
    /// Updates the box of the present model; the view stays.
    void setBox(const core::Box& box);
    const core::Box& box() const { return m_box; }

    /// Shows the whole box from the present direction.
    void frame();
    void turnTo(OrbitCamera::Side side);
    void setView(const core::SavedView& view);
    void setProjection(OrbitCamera::Projection projection);
    /// Turns the view by these angles in degrees to the right and down, as a drag does.
    void turn(double right, double down);
    /// Zooms towards a pixel, or the centre of the view if none is given. `factor` < 1 moves nearer.
    void zoom(double factor, const std::optional<OrbitCamera::Pixel>& toward = {});
    /// Turns the model about the Y axis by `angle` radians in `seconds`, anticlockwise seen from above, also during a
    /// stroke. While the view follows the avatar's head, the model turns only during strokes.
    void turnModel(double angle, double seconds);

    /// Flies to a place on the surface of size `extent`, mm, and marks it.
    void flyTo(const core::Vec3& point, const core::Vec3& normal, double extent);
    /// Flies to a pose from which the whole box is visible. Angles in radians as in OrbitCamera::Pose.
    void flyTo(const core::Box& box, double yaw, double pitch);
    /// Removes the mark. A flight to it stops where it is.
    void clearMark();
    const std::optional<Mark>& mark() const { return m_mark; }
    /// Stops a flight where it is.
    void stop() { m_flight.stop(); }
    /// Turns flights on or off; without them the view jumps.
    void setReducesMotion(bool reducesMotion) { m_reducesMotion = reducesMotion; }
    bool reducesMotion() const { return m_reducesMotion; }

    /// Sets the avatar; nullopt removes it and ends following.
    void setAvatar(const std::optional<HeadsetAvatar>& avatar);
    /// Returns the avatar to draw, without its head while the view follows the head.
    std::optional<HeadsetAvatar> shownAvatar() const;
    /// Starts or ends following the position and direction of the avatar's head, smoothed. Also ends when the user,
    /// frame(), turnTo() or flyTo() moves the view. Does not start without an avatar.
    void setFollowing(bool on);
    bool isFollowing() const { return m_following.isActive(); }

Q_SIGNALS:
    void followingChanged(bool on);
    void markChanged();

private:
    void follow();
    void fly(const OrbitCamera::Pose& to);

    OrbitCamera* m_camera;
    PointerInput* m_input;
    core::Box m_box;
    std::optional<Mark> m_mark;
    OrbitCamera::Pose m_from, m_to; ///< start and end of the flight
    QVariantAnimation m_flight;
    bool m_reducesMotion = false;
    std::optional<HeadsetAvatar> m_avatar;
    QTimer m_following; ///< runs while the view follows the head
    QElapsedTimer m_sinceFollowed;
};
} // namespace ui
