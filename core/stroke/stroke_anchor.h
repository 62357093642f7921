#pragma once

#include "core/stroke/stroke.h"

#include <vector>

namespace core
{
/// The anchor of a drag tool's stroke: where the stroke took hold, where the brush is now, and its motion from dab to
/// dab.
class StrokeAnchor
{
public:
    explicit StrokeAnchor(const StrokeSettings& settings) : m_settings(settings) {}

    /// Sets the position, in model space, of the pointer at the first dab. SnakeHook keeps the offset between this
    /// position and the dab's centre.
    void takeHold(const Vec3& hand) { m_hand = hand; }
    /// Returns whether a drag tool's first dab has set the anchor. Later dabs then get their position from placeOf()
    /// instead of the surface.
    bool isSet() const { return m_anchor.has_value() && isDragTool(m_settings.tool); }
    /// Returns the point that a sample's position and direction, in model space, lead to. A ray is intersected with the
    /// plane through the anchor perpendicular to the first ray; returns nothing if it does not meet that plane, or only
    /// at a very small angle. Without rays, returns the position plus a constant offset.
    std::optional<Vec3> placeOf(const Vec3& position, const Vec3& direction) const;

    /// Returns the dabs, at most 20, that lead from the previous dab to this one, to be placed one after the other. The
    /// dabs of a drag tool move by at most 0.1 radii each, unless the pointer jumps by more than 2: the surface is
    /// refined as it is stretched, whether the pointer moves slowly or fast. Other tools have one dab.
    std::vector<Dab> divide(const Dab& dab) const;
    /// Sets the dab's motion, turn and position; on entry its position is the pointer's. Tools that keep their
    /// selection stay at the anchor. SnakeHook moves to its tip.
    void place(Dab& dab);
    /// Moves SnakeHook's tip by the dab's motion, scaled by the share of the displacement that was reached.
    void follow(const Dab& dab, const DabReport& report);

private:
    double turnBy(const Dab& dab);

    struct Anchor
    {
        Vec3 position, direction;
    };
    StrokeSettings m_settings;
    std::optional<Anchor> m_anchor; ///< position and direction of the first dab
    /// pointer position at the first dab; offset from there to the dab's centre
    Vec3 m_hand = Vec3::Zero(), m_offset = Vec3::Zero();
    Vec3 m_last = Vec3::Zero(); ///< pointer position at the previous dab
    Vec3 m_tip = Vec3::Zero();
    Vec3 m_pulled = Vec3::Zero();  ///< Twist: direction of the stroke's first motion, of unit length, or zero
    Vec3 m_heading = Vec3::Zero(); ///< SnakeHook: see Dab::heading
    double m_sense = 1; ///< Twist: sense of rotation for motion along m_pulled: 1 anticlockwise, -1 clockwise
};
} // namespace core
