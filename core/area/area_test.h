#pragma once

#include "core/area/fitted_loops.h"
#include "core/area/sight.h"

namespace core
{
/// Tells which points lie in an area of the view, regardless of symmetry and of what is in front. Thread: any; the
/// object is immutable.
class AreaTest
{
public:
    /// Cost: quadratic in the corners.
    explicit AreaTest(const ViewArea& area);

    /// Returns false if the curve has no area or is too tangled, or a corner is beside or behind the eye.
    bool hasArea() const { return !m_loops.loops().empty(); }
    /// Returns whether the point is within the curve, whichever side is meant. Cost: about the square root of the
    /// number of corners.
    bool isWithin(const Vec3& p) const;
    const Sight& sight() const { return m_sight; }

private:
    struct Edge
    {
        Eigen::Vector2d from, to;
    };

    std::size_t bandOf(double y) const;

    Sight m_sight;
    FittedLoops m_loops;
    double m_bottom = 0, m_bandHeight = 1;  ///< in units of the loops
    std::vector<std::vector<Edge>> m_bands; ///< edges by level bands, from the bottom
};
} // namespace core
