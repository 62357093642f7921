#pragma once

#include "core/geometry/lattice.h"

namespace core
{
/// Integer box on the lattice, bounds included. The default box is empty.
struct LatticeBox
{
    LatticePoint min = LatticePoint::Constant(std::numeric_limits<int>::max());
    LatticePoint max = LatticePoint::Constant(std::numeric_limits<int>::min());

    void extend(const LatticePoint& p) { min = min.cwiseMin(p), max = max.cwiseMax(p); }
    void extend(const LatticeBox& b) { min = min.cwiseMin(b.min), max = max.cwiseMax(b.max); }
    bool empty() const { return min.x() > max.x(); }
    bool meets(const LatticeBox& b) const
    {
        return min.x() <= b.max.x() && b.min.x() <= max.x() && min.y() <= b.max.y() && b.min.y() <= max.y() &&
               min.z() <= b.max.z() && b.min.z() <= max.z();
    }
    bool contains(const LatticeBox& b) const
    {
        return (min.array() <= b.min.array()).all() && (b.max.array() <= max.array()).all();
    }
};

/// Returns the smallest lattice box that contains the ball, clipped to the lattice.
LatticeBox latticeBox(const Lattice& lattice, const Sphere& ball);
} // namespace core
