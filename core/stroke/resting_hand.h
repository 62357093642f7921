#pragma once

#include "core/stroke/stroke.h"

namespace core
{
/// The hand of a stroke with an airbrush: whether it rests, and when its next dab is due. Measures the hand, not what
/// is under it, which the dabs move.
class RestingHand
{
public:
    explicit RestingHand(const StrokeSettings& settings);

    /// Starts anew with a dab on the path. `hand`: the sample's position, in the model's space, mm; `time`: seconds.
    void follow(const Dab& dab, const Vec3& hand, double time);
    /// Whether the hand is still where it was at the last dab. False without an airbrush, and before the first dab.
    bool isAtRest(const Dab& dab, const Vec3& hand) const;
    /// Whether a dab is due at that time. If so it is counted: the next one is due later.
    bool takeDab(const Dab& dab, const Vec3& hand, double time);

private:
    double interval() const;

    double m_rate = 0; ///< dabs a second; 0: none
    bool m_isRay = false;
    bool m_hasDab = false, m_isResting = false;
    Vec3 m_hand = Vec3::Zero(), m_direction = Vec3::Zero(); ///< at the last dab; the direction of unit length
    double m_time = 0;                                      ///< of the last dab, seconds
};
} // namespace core
