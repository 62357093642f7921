#pragma once

#include "vr/util/pose.h"

namespace vr
{
/// Where the model stands in the room: a similarity from document space (mm) to room space (m). It is a way to look at
/// the model and changes no millimetre of it; a brush of one length in the room is smaller on a model that is shown
/// larger. Nothing here but place() and what hands do changes it: a model that grows, or a new object, never moves what
/// is seen.
class ModelPlacement
{
public:
    // Where a person finds a model, in metres.
    static constexpr double comfortableSize = 0.5;  ///< its longest side, as shown
    static constexpr double comfortableReach = 0.6; ///< from the head to its middle: an arm bent a little
    static constexpr double belowEyes = 0.2;        ///< its middle: one looks down at one's work
    // How large it may be shown; from the size of a nut to that of a house.
    static constexpr double minSize = 0.02, maxSize = 20;

    /// `model`: its box, mm; an empty one counts as that of a ball of 100 mm.
    explicit ModelPlacement(const core::Box& model = {});
    /// Its box has changed: from now on it turns and grows about another middle, and has other bounds. What is seen
    /// stays.
    void setModel(const core::Box& model);

    /// In front of a head, upright, its front (+Z) turned to it, at a comfortable size. A head standing or seated,
    /// anywhere in the room, looking anywhere. `heightOffset`: metres higher, if the user wants it so.
    void place(const Pose& head, double heightOffset = 0);

    /// Turns the model about the document's Y axis as it stands in the room (paper, section 3.5.4), the axis of
    /// symmetry and of the window's turntable; radians, anticlockwise seen from above. Clockwise, which the paper has
    /// at the left of the pad, the side that faces the person goes to the left.
    void turn(double angle);
    /// Turns the model the shortest way about its middle until the document's Y axis is vertical.
    void level();
    /// About the model's middle. `factor` above 0; as far as the bounds go.
    void scale(double factor);
    /// The model goes as if it were tied to what goes from here to there. Room space.
    void move(const Pose& from, const Pose& to);

    /// Two points of the room, metres.
    struct Span
    {
        core::Vec3 a = core::Vec3::Zero(), b = core::Vec3::Zero();
    };
    /// The model goes with two hands: the middle between them with the middle, turned the shortest way and scaled, as
    /// far as the bounds go, as what lies between them.
    void stretch(const Span& from, const Span& to);

    /// Of unit length, always.
    const Eigen::Quaterniond& rotation() const { return m_rotation; }
    /// Document to room.
    Eigen::Affine3d matrix() const;
    /// Where the model's middle is in the room.
    core::Vec3 middle() const { return toRoom(m_middle); }

    core::Vec3 toRoom(const core::Vec3& point) const { return m_scale * (m_rotation * point) + m_origin; }
    core::Vec3 toModel(const core::Vec3& point) const { return m_rotation.conjugate() * (point - m_origin) / m_scale; }
    /// Directions keep their length.
    core::Vec3 directionToRoom(const core::Vec3& direction) const { return m_rotation * direction; }
    core::Vec3 directionToModel(const core::Vec3& direction) const { return m_rotation.conjugate() * direction; }
    double lengthToRoom(double mm) const { return mm * m_scale; }
    double lengthToModel(double metres) const { return metres / m_scale; }

private:
    double clampedScale(double factor) const;
    void scaleAbout(const core::Vec3& point, double factor);
    void rotateAbout(const core::Vec3& point, const Eigen::Quaterniond& rotation);

    core::Vec3 m_middle; ///< of the model's box, mm
    double m_size = 1;   ///< its longest side, mm
    double m_scale = 1;  ///< metres per mm
    Eigen::Quaterniond m_rotation = Eigen::Quaterniond::Identity();
    core::Vec3 m_origin = core::Vec3::Zero(); ///< the document's, in the room
};
} // namespace vr
