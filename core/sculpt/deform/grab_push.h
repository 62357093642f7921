#pragma once

#include "core/sculpt/select/region.h"
#include "core/stroke/stroke.h"
#include "core/util/slot_set.h"

#include <array>

namespace core
{
/// The weight with which Grab pushes what lies ahead of the surface that it holds. Without it, the held surface slides
/// over the rest and folds.
///
/// A vertex at the distance r from where the stroke took hold has the weight w = b(r/R), and has moved by w m, where m
/// is the motion of the stroke. So the vertices with a weight of at least w are in a ball of the radius r(w) that has
/// moved by w m. Such a ball pushes what is in it with the weight w. In addition, the hand pushes by b(3/2 r/R), where
/// r is the distance from the hand. The largest weight counts. All depends on m only, so that a hand that moves back
/// takes back what it has pushed. Only the part of the surface that the hand holds is pushed; other parts are to be met
/// and joined. Cost: up to 0.1 us a place.
class GrabPush
{
public:
    /// `region`: what the stroke took hold of. `moved`: m, mm.
    GrabPush(const Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab, const Vec3& moved);

    /// Returns the vertices of the region that the hand holds: edges within the region connect them with the vertex
    /// nearest to the brush's centre.
    const SlotSet& held() const { return m_held; }
    /// Returns the weight, 0 to 1, of a held vertex at this place that the brush gives `weight`; not less than that.
    double at(const Vec3& place, double weight) const;

private:
    static constexpr std::size_t steps = 32;

    void findHeld(const Region& region, const Mesh& mesh);
    double byHand(double distance) const;

    SlotSet m_held;
    Vec3 m_center; ///< where the stroke took hold
    Vec3 m_moved;
    double m_step;                             ///< by which the balls' radii differ, mm
    std::array<double, steps + 1> m_weights{}; ///< of the balls, the smallest first
};
} // namespace core
