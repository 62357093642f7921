#pragma once

#include "ui/settings/reference_placement.h"

#include "core/io/document_metadata.h"

#include <Eigen/Core>

#include <optional>

namespace ui
{
/// A camera that turns about a point. World space is model space: mm, Y up. Pixels are logical, with the origin at the
/// top left and y down. Independent of Qt and OpenGL.
class OrbitCamera
{
public:
    using Pixel = Eigen::Vector2d;

    enum class Projection { Perspective, Orthographic };
    using Side = ViewSide;

    /// Sets the size of the view in logical pixels; values below 1 count as 1.
    void setViewport(double width, double height);
    Pixel viewport() const { return {m_width, m_height}; }

    /// Shows the whole box from the present direction; an empty box counts as a cube of 100 mm about the origin.
    void frame(const core::Box& box);
    /// Turns to the initial direction of a new model: the front, seen slightly from the right and above.
    void turnToFirst();
    /// Sets the box that must be between near and far plane. frame() also sets it.
    void setScene(const core::Box& box);

    /// Changes the projection. Sizes at the target's depth are kept.
    void setProjection(Projection projection) { m_projection = projection; }
    Projection projection() const { return m_projection; }

    /// Sets the point that orbit() and turnTo() turn about, which stays at its place in the view. nullopt: the scene's
    /// centre. setScene() removes a pivot outside the new scene's bounding sphere.
    void setPivot(const std::optional<core::Vec3>& pivot) { m_pivot = pivot; }
    core::Vec3 pivot() const { return m_pivot.value_or(m_sceneCenter); }
    /// Turns by a drag of `delta` logical pixels. A drag over the view's height is half a turn.
    void orbit(const Pixel& delta);
    void turnTo(Side side);
    /// Turns the camera about the Y axis by -`angle` radians, so that the model seems to turn anticlockwise seen from
    /// above.
    void turnModel(double angle);

    /// Moves the target along the view direction to the point's depth without changing the view. pan() and zoom() use
    /// the target's depth. A point behind the eye or too near to zoom to counts as the nearest allowed.
    void setTargetDepth(const core::Vec3& point);
    /// Moves the view by `delta` logical pixels. Points at the target's depth follow the pointer.
    void pan(const Pixel& delta);
    /// Scales the distance to the target; `factor` < 1 moves nearer. A point at the target's depth under the pixel
    /// stays under it.
    void zoom(double factor, const Pixel& toward);

    core::SavedView saved() const;
    /// Restores a saved view and resets the pivot to the scene's centre. Ignores a view whose target is more than 40
    /// times the scene's radius away from the scene's centre.
    void setView(const core::SavedView& view);

    core::Vec3 target() const { return m_target; }
    /// distance from eye to target, mm; also sets the scale of orthographic views
    double distance() const { return m_distance; }
    core::Vec3 eye() const;
    core::Vec3 viewDirection() const; ///< unit vector from the eye into the view
    core::Vec3 right() const;
    core::Vec3 up() const;

    /// Returns the ray of a pixel, with unit direction. Its origin is the eye, or in orthographic views a point on the
    /// near plane, in front of all visible geometry.
    core::Ray ray(const Pixel& pixel) const;
    /// Returns the intersection of a ray with the plane that faces the camera and contains the pivot, or the target if
    /// the pivot is behind the eye.
    core::Vec3 acrossPivot(const core::Ray& ray) const;
    /// Returns the position of a point in the view, logical pixels. Meaningless in perspective for a point behind the
    /// eye.
    Pixel project(const core::Vec3& point) const;
    /// Returns the logical pixels per mm for a length parallel to the view plane at this point.
    double pixelsPerMm(const core::Vec3& at) const;

    /// Position and direction of the camera. Animations interpolate between two poses.
    struct Pose
    {
        core::Vec3 target;
        double distance, yaw, pitch;
    };
    Pose pose() const { return {m_target, m_distance, m_yaw, m_pitch}; }
    void setPose(const Pose& pose);
    /// Returns a pose that looks at a surface point with this normal, slightly from above, with `extent` mm filling a
    /// third of the view.
    Pose facing(const core::Vec3& point, const core::Vec3& normal, double extent) const;
    /// Returns a pose with the eye at this point and this direction in radians. The target is at the distance of the
    /// scene's centre.
    Pose standing(const core::Vec3& eye, double yaw, double pitch) const;
    /// Returns the pose at `share` (0 to 1) of the way, turning in the shorter direction.
    static Pose between(const Pose& from, const Pose& to, double share);

    /// Matrices for column vectors and OpenGL clip space (-1 to 1).
    Eigen::Matrix4d viewMatrix() const;
    Eigen::Matrix4d projectionMatrix() const;

    /// Distances from the eye in mm. An orthographic near plane may be behind the eye.
    double nearPlane() const;
    double farPlane() const;

private:
    void turn(double yaw, double pitch);
    double reachable(double distance) const;
    double depthOf(const core::Vec3& point) const;
    double sizeDepth(const core::Vec3& point) const;
    Eigen::Matrix3d axes() const;

    double m_width = 1, m_height = 1;
    core::Vec3 m_target = core::Vec3::Zero();
    double m_distance = 300;
    Projection m_projection = Projection::Perspective;
    std::optional<core::Vec3> m_pivot;
    static constexpr double firstYaw = 0.5, firstPitch = 0.35;
    double m_yaw = firstYaw, m_pitch = firstPitch; ///< radians; (0, 0) looks along -Z, pitch > 0 looks down
    core::Vec3 m_sceneCenter = core::Vec3::Zero();
    double m_sceneRadius = 100;
};
} // namespace ui
