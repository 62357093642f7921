#pragma once

#include "core/stroke/stroke.h"

namespace core
{
/// Where the hand is, for tools that follow it, and how far it has come from dab to dab.
class Hand
{
public:
    explicit Hand(const StrokeSettings& settings) : m_settings(settings) {}

    /// From its first dab on such a tool asks here where the hand is, and no longer the surface.
    bool leads() const { return m_grip.has_value() && followsHand(m_settings.tool); }
    /// Of a sample's position and direction, in the model's space. A ray leads the hand over the plane through where it took hold, across
    /// the first ray. Nothing if it runs along that plane or away from it.
    std::optional<Vec3> placeOf(const Vec3& position, const Vec3& direction) const;

    /// Gives the dab, whose position is the hand's, its motion and turn, and where it works: a tool that holds on where it took hold,
    /// Snake at its tip.
    void lead(Dab& dab);
    /// Snake's tip came so far.
    void moved(const Dab& dab, const DabReport& report);

private:
    double turnBy(const Dab& dab);

    struct Grip
    {
        Vec3 position, direction;
    };
    StrokeSettings m_settings;
    std::optional<Grip> m_grip; ///< of the first dab
    Vec3 m_last = Vec3::Zero(); ///< the hand's place at the dab before
    Vec3 m_tip = Vec3::Zero();
    Vec3 m_pulled = Vec3::Zero(); ///< Twist: the way of its first motion, of unit length, or zero
    double m_sense = 1;           ///< Twist: 1 anticlockwise, -1 clockwise
};
} // namespace core
