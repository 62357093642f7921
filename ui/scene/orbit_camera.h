#pragma once

#include "ui/settings/reference_placement.h"

#include "core/io/document_metadata.h"

#include <Eigen/Core>

#include <optional>

namespace ui
{
/// A camera that turns about a point. World space = model space, mm, Y up; pixels are logical, origin at the top left,
/// y down. Pure mathematics: no Qt, no OpenGL.
class OrbitCamera
{
public:
    using Pixel = Eigen::Vector2d;

    enum class Projection { Perspective, Orthographic };
    using Side = ViewSide;

    /// Logical pixels, at least 1 x 1.
    void setViewport(double width, double height);
    Pixel viewport() const { return {m_width, m_height}; }

    /// Shows the whole box from the present direction; an empty box is taken as 100 mm about the origin.
    void frame(const core::Box& box);
    /// Turns to the direction that a new model is shown from: the front, a little from the right and above.
    void turnToFirst();
    /// What near and far plane must hold; frame() sets it too.
    void setScene(const core::Box& box);

    /// The size at the target's depth stays as it is.
    void setProjection(Projection projection) { m_projection = projection; }
    Projection projection() const { return m_projection; }

    /// What orbit() and turnTo() turn about; it keeps its place in the picture. None: the scene's centre. It is given
    /// up when the scene is no longer where it was.
    void setPivot(const std::optional<core::Vec3>& pivot) { m_pivot = pivot; }
    core::Vec3 pivot() const { return m_pivot.value_or(m_sceneCenter); }
    /// A drag by so many pixels. The view's height is half a turn.
    void orbit(const Pixel& delta);
    void turnTo(Side side);
    /// As if the model turned about the Y axis, anticlockwise seen from above: the camera goes round it the other way.
    /// Radians.
    void turnModel(double angle);

    /// The target moves along the view to the point's depth, the picture stays: pan() and zoom() go by that depth. A
    /// point too near to zoom to, or behind the eye, counts as the nearest.
    void setTargetDepth(const core::Vec3& point);
    /// The point at the target's depth follows the pointer.
    void pan(const Pixel& delta);
    /// `factor` < 1 comes nearer. What lies under the pixel at the target's depth stays under it.
    void zoom(double factor, const Pixel& toward);

    core::SavedView saved() const;
    /// Of a view that does not see the scene, nothing. The pivot is the scene's centre again.
    void setView(const core::SavedView& view);

    core::Vec3 target() const { return m_target; }
    double distance() const { return m_distance; } ///< from eye to target; says the size in orthographic views too
    core::Vec3 eye() const;
    core::Vec3 viewDirection() const; ///< unit length, from the eye into the picture
    core::Vec3 right() const;
    core::Vec3 up() const;

    /// Origin at the eye, in orthographic views on the near plane: ahead of all that is seen. Unit direction.
    core::Ray ray(const Pixel& pixel) const;
    /// Where a ray meets the plane through the pivot that faces the camera; through the target if the pivot lies behind
    /// the eye.
    core::Vec3 acrossPivot(const core::Ray& ray) const;
    /// In pixels; in perspective a point behind the eye has no meaningful answer.
    Pixel project(const core::Vec3& point) const;
    /// How many logical pixels a length of 1 mm, parallel to the picture at that point, covers.
    double pixelsPerMm(const core::Vec3& at) const;

    /// Where it stands; what lies between two is a flight.
    struct Pose
    {
        core::Vec3 target;
        double distance, yaw, pitch;
    };
    Pose pose() const { return {m_target, m_distance, m_yaw, m_pitch}; }
    void setPose(const Pose& pose);
    /// Looks at a point of a surface with that normal, a little from above, so that `extent` mm fill a third of the
    /// picture.
    Pose facing(const core::Vec3& point, const core::Vec3& normal, double extent) const;
    /// Stands there and looks so; the target is as far away as the scene's centre.
    Pose standing(const core::Vec3& eye, double yaw, double pitch) const;
    /// `share` 0 to 1 of the way, the shorter way round.
    static Pose between(const Pose& from, const Pose& to, double share);

    /// Column vectors, OpenGL clip space (-1..1).
    Eigen::Matrix4d viewMatrix() const;
    Eigen::Matrix4d projectionMatrix() const;

    /// Distances from the eye; an orthographic near plane may lie behind it.
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
    double m_yaw = firstYaw, m_pitch = firstPitch; ///< radians; 0, 0 looks along -Z, pitch > 0 looks down
    core::Vec3 m_sceneCenter = core::Vec3::Zero();
    double m_sceneRadius = 100;
};
} // namespace ui
