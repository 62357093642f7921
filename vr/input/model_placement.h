#pragma once

#include "vr/util/pose.h"

namespace vr
{
/// Position, orientation and scale of the model in the room: a similarity from document space (mm) to room space (m).
/// It changes how the model is seen, never the model itself. A brush of fixed size in the room is smaller on a model
/// that is shown larger.
///
/// The placement changes only by place() and by the user's actions. setModel() does not move what is seen, even if the
/// model has grown or another one was opened.
class ModelPlacement
{
public:
    // Values that place() uses, in metres.
    static constexpr double comfortableSize = 0.5; ///< longest side of the model as shown
    /// Horizontal distance from the head to the model's middle: an arm bent a little.
    static constexpr double comfortableReach = 0.6;
    /// Distance from the eyes down to the model's middle: users look down at their work.
    static constexpr double belowEyes = 0.2;
    // Range of the longest side as shown, in metres: from the size of a nut to that of a house.
    static constexpr double minSize = 0.02, maxSize = 20;

    /// `model`: bounding box of the model, mm; an empty box counts as a cube of 100 mm.
    explicit ModelPlacement(const core::Box& model = {});
    /// Sets the bounding box of a changed model: level() and scale() use its middle, and its size limits the scale.
    /// The visible model does not move.
    void setModel(const core::Box& model);

    /// Places the model in front of a head, upright, at a comfortable size, with its front (+Z) turned to the head. The
    /// head may stand or sit anywhere and look anywhere. `heightOffset`: metres that the model is raised.
    void place(const Pose& head, double heightOffset = 0);

    /// Turns the model about the document's Y axis as that is in the room (paper, section 3.5.4), the axis of the
    /// window's turntable. Units: radians, anticlockwise seen from above. A clockwise turn, which the paper has at the
    /// left of the pad, moves the side facing the user to the left.
    void turn(double angle);
    /// Turns the model about its middle, the shortest way, until the document's Y axis is vertical.
    void level();
    /// Scales the model about its middle, within minSize and maxSize. Precondition: `factor` is above 0.
    void scale(double factor);
    /// Moves the model as if it were tied to an object that moves from `from` to `to`. Units: room space.
    void move(const Pose& from, const Pose& to);

    /// Two points in room space, metres.
    struct Span
    {
        core::Vec3 a = core::Vec3::Zero(), b = core::Vec3::Zero();
    };
    /// Moves the model with two hands. It is shifted with the point midway between them, turned the shortest way with
    /// the line between them, and scaled with their distance, within minSize and maxSize.
    void stretch(const Span& from, const Span& to);

    /// Returns the rotation, always of unit length.
    const Eigen::Quaterniond& rotation() const { return m_rotation; }
    /// Returns the transform from document space to room space.
    Eigen::Affine3d matrix() const;
    /// Returns the middle of the model in room space.
    core::Vec3 middle() const { return toRoom(m_middle); }

    core::Vec3 toRoom(const core::Vec3& point) const { return m_scale * (m_rotation * point) + m_origin; }
    core::Vec3 toModel(const core::Vec3& point) const { return m_rotation.conjugate() * (point - m_origin) / m_scale; }
    /// Rotates a direction into room space; its length does not change.
    core::Vec3 directionToRoom(const core::Vec3& direction) const { return m_rotation * direction; }
    core::Vec3 directionToModel(const core::Vec3& direction) const { return m_rotation.conjugate() * direction; }
    double lengthToRoom(double mm) const { return mm * m_scale; }
    double lengthToModel(double metres) const { return metres / m_scale; }

private:
    double clampedScale(double factor) const;
    void scaleAbout(const core::Vec3& point, double factor);
    void rotateAbout(const core::Vec3& point, const Eigen::Quaterniond& rotation);

    core::Vec3 m_middle; ///< middle of the model's bounding box, mm
    double m_size = 1;   ///< longest side of the model's bounding box, mm
    double m_scale = 1;  ///< metres per mm
    Eigen::Quaterniond m_rotation = Eigen::Quaterniond::Identity();
    core::Vec3 m_origin = core::Vec3::Zero(); ///< document's origin in room space, metres
};
} // namespace vr
