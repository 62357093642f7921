#pragma once

#include "core/stroke/stroke.h"

namespace core
{
/// Anchor of a drag tool's stroke: where the brush took hold, where it is, and its motion from dab to dab.
class StrokeAnchor
{
public:
    explicit StrokeAnchor(const StrokeSettings& settings) : m_settings(settings) {}

    /// Sets the hand's place, in the model's space, for the first dab: SnakeHook keeps the distance between both.
    void takeHold(const Vec3& hand) { m_hand = hand; }
    /// Returns whether a drag tool has taken hold: from its first dab on it takes its place from here.
    bool isSet() const { return m_anchor.has_value() && isDragTool(m_settings.tool); }
    /// Returns where a sample's position and direction, in the model's space, lead the hand. A ray leads it over the
    /// plane through where it took hold, across the first ray. Returns nothing if the ray does not meet that plane.
    std::optional<Vec3> placeOf(const Vec3& position, const Vec3& direction) const;

    /// Gives the dab, whose position is the hand's, its motion and turn, and where it works: a tool that keeps its
    /// selection where it took hold, SnakeHook at its tip.
    void place(Dab& dab);
    /// Moves SnakeHook's tip by the share of its way that the dab reached.
    void follow(const Dab& dab, const DabReport& report);

private:
    double turnBy(const Dab& dab);

    struct Anchor
    {
        Vec3 position, direction;
    };
    StrokeSettings m_settings;
    std::optional<Anchor> m_anchor;                      ///< of the first dab
    Vec3 m_hand = Vec3::Zero(), m_offset = Vec3::Zero(); ///< where it took hold; the way from there to the dab
    Vec3 m_last = Vec3::Zero();                          ///< the hand's place at the dab before
    Vec3 m_tip = Vec3::Zero();
    Vec3 m_pulled = Vec3::Zero();  ///< Twist: the way of its first motion, of unit length, or zero
    Vec3 m_heading = Vec3::Zero(); ///< SnakeHook: as Dab::heading
    double m_sense = 1;            ///< Twist: 1 anticlockwise, -1 clockwise
};
} // namespace core
