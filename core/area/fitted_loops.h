#pragma once

#include "core/area/winding_outline.h"

namespace core
{
/// The loops around the area of a plane curve, on a plane lattice that is fitted to it. Thread: any; immutable.
class FittedLoops
{
public:
    /// Cost: windingOutline().
    explicit FittedLoops(const std::vector<Eigen::Vector2d>& curve);

    /// The loops; none if the curve has no area, or is too tangled.
    const std::vector<FlatLoop>& loops() const { return m_loops; }
    /// Converts between the lattice and the curve's plane.
    Eigen::Vector2d placeOf(const FlatPoint& p) const { return m_center + m_unit * p.cast<double>(); }
    Eigen::Vector2d inUnits(const Eigen::Vector2d& p) const { return (p - m_center) / m_unit; }

private:
    std::vector<FlatLoop> m_loops;
    Eigen::Vector2d m_center = Eigen::Vector2d::Zero();
    double m_unit = 1;
};
} // namespace core
