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
/// Moves the view where a command, a found place or the headset wants it: at once, by a flight, or behind the head of
/// the avatar. Thread: gui.
class ViewNavigation : public QObject
{
    Q_OBJECT

public:
    struct Mark
    {
        core::Vec3 point, normal;
        double radius;
    };

    /// Neither is owned. The input says when the user moves the view, and is told when the view moves.
    ViewNavigation(OrbitCamera* camera, PointerInput* input, QObject* parent = nullptr);

    /// Frames another model, from the front and above.
    void showModel(const core::Box& box);
    /// The same model has another box now; the view stays.
    void setBox(const core::Box& box);
    const core::Box& box() const { return m_box; }

    /// Shows the whole box from the present direction.
    void frame();
    void turnTo(OrbitCamera::Side side);
    void setView(const core::SavedView& view);
    void setProjection(OrbitCamera::Projection projection);
    /// Turns the view by degrees to the right and down, as a drag would.
    void turn(double right, double down);
    /// `factor` < 1 comes nearer: to `toward`, else to the middle of the view.
    void zoom(double factor, const std::optional<OrbitCamera::Pixel>& toward = {});
    /// Turns the model about the Y axis by `angle` radians in `seconds`, anticlockwise seen from above; under an open
    /// stroke, too. While the view follows a head only under such a stroke.
    void turnModel(double angle, double seconds);

    /// Flies to a place of the surface that is `extent` mm large, and marks it.
    void flyTo(const core::Vec3& point, const core::Vec3& normal, double extent);
    /// Flies to where the whole box is seen from there; radians as of OrbitCamera::Pose.
    void flyTo(const core::Box& box, double yaw, double pitch);
    /// A flight to it ends where it is.
    void clearMark();
    const std::optional<Mark>& mark() const { return m_mark; }
    /// Ends a flight where it is.
    void stop() { m_flight.stop(); }
    /// Calm: without flights.
    void setReducesMotion(bool reducesMotion) { m_reducesMotion = reducesMotion; }
    bool reducesMotion() const { return m_reducesMotion; }

    /// Nobody: following ends.
    void setAvatar(const std::optional<HeadsetAvatar>& avatar);
    /// Returns the avatar to draw: without the head while the view follows it.
    std::optional<HeadsetAvatar> shownAvatar() const;
    /// The view goes, smoothed, where the avatar's head is and looks, until the user, frame(), turnTo() or flyTo()
    /// moves it elsewhere. Does not begin without an avatar.
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
    OrbitCamera::Pose m_from, m_to; ///< of the flight
    QVariantAnimation m_flight;
    bool m_reducesMotion = false;
    std::optional<HeadsetAvatar> m_avatar;
    QTimer m_following; ///< runs while the view follows the head
    QElapsedTimer m_sinceFollowed;
};
} // namespace ui
