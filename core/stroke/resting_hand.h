#pragma once

#include "core/stroke/stroke.h"

namespace core
{
/// Decides, for a stroke with an airbrush, whether the pointer is at rest and when its next dab is due. Looks only at
/// the samples and not at the surface, because the dabs move the surface.
class RestingHand
{
public:
    explicit RestingHand(const StrokeSettings& settings);

    /// Restarts the timing after a dab on the path. `hand`: the sample's position in model space, mm. `time`: seconds.
    void follow(const Dab& dab, const Vec3& hand, double time);
    /// Returns whether the pointer is still where it was at the last dab. Returns false for a stroke without an
    /// airbrush, and before the first dab.
    bool isAtRest(const Dab& dab, const Vec3& hand) const;
    /// Returns whether a dab is due at this time, in seconds. If so, counts it as done, and the next one is due later.
    bool takeDab(const Dab& dab, const Vec3& hand, double time);

private:
    double interval() const;

    double m_rate = 0; ///< dabs per second; 0: no airbrush
    bool m_isRay = false;
    bool m_hasDab = false, m_isResting = false;
    /// position and unit direction of the sample of the last dab
    Vec3 m_hand = Vec3::Zero(), m_direction = Vec3::Zero();
    double m_time = 0; ///< time of the last dab, seconds
};
} // namespace core
