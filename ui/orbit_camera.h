#pragma once

#include "core/geometry.h"

#include <Eigen/Core>

namespace ui
{
/// A camera that turns about a point. World space = model space, mm, Y up; pixels are logical, origin at the top left,
/// y down. Pure mathematics: no Qt, no OpenGL.
class OrbitCamera
{
public:
    using Pixel = Eigen::Vector2d;

    /// Logical pixels, at least 1 x 1.
    void setViewport(double width, double height);
    Pixel viewport() const { return {m_width, m_height}; }

    /// Shows the whole box from the present direction; an empty box is taken as 100 mm about the origin.
    void frame(const core::Box& box);
    /// What near and far plane must hold; frame() sets it too.
    void setScene(const core::Box& box);

    /// A drag by so many pixels. The view's height is half a turn.
    void orbit(const Pixel& delta);
    /// The point at the target's depth follows the pointer.
    void pan(const Pixel& delta);
    /// `factor` < 1 comes nearer. What lies under the pixel at the target's depth stays under it.
    void zoom(double factor, const Pixel& toward);

    core::Vec3 target() const { return m_target; }
    double distance() const { return m_distance; }
    core::Vec3 eye() const;
    core::Vec3 viewDirection() const; ///< unit length, from the eye into the picture
    core::Vec3 right() const;
    core::Vec3 up() const;

    /// Origin on the near side, at the eye; unit direction.
    core::Ray ray(const Pixel& pixel) const;
    /// In pixels; a point behind the eye has no meaningful answer.
    Pixel project(const core::Vec3& point) const;
    /// How many logical pixels a length of 1 mm, parallel to the picture at that point, covers.
    double pixelsPerMm(const core::Vec3& at) const;

    /// Column vectors, OpenGL clip space (-1..1).
    Eigen::Matrix4d viewMatrix() const;
    Eigen::Matrix4d projectionMatrix() const;

    double nearPlane() const;
    double farPlane() const;

private:
    double depthOf(const core::Vec3& point) const;

    double m_width = 1, m_height = 1;
    core::Vec3 m_target = core::Vec3::Zero();
    double m_distance = 300;
    double m_yaw = 0.5, m_pitch = 0.35; ///< radians; 0, 0 looks along -Z, pitch > 0 looks down
    core::Vec3 m_sceneCenter = core::Vec3::Zero();
    double m_sceneRadius = 100;
};
} // namespace ui
