#pragma once

#include "core/geometry/geometry.h"

#include <cmath>

namespace core
{
/// A point on the lattice, in units of Lattice::unit(). Each |coordinate| <= Lattice::limit.
using LatticePoint = Eigen::Vector3i;

/// Coordinates of a document are integer multiples of one unit u = 2^-k (in the document's unit, mm), |integer| <=
/// 2^23. A float32 holds each of them exactly, so what is verified is bit for bit what is drawn and exported, and
/// predicates on the integers are exact.
class Lattice
{
public:
    static constexpr int limit = 1 << 23;
    /// Smallest d_detail in lattice units; keeps rounding far below an edge's length.
    static constexpr int minDetailUnits = 1024;

    explicit Lattice(int k = 14) : m_k(k), m_unit(std::ldexp(1.0, -k)), m_perUnit(std::ldexp(1.0, k)) {}

    /// Returns the finest lattice that reaches at least 8 x `largestCoordinate` (> 0, absolute, mm) from the origin.
    static Lattice forExtent(double largestCoordinate);

    int exponent() const { return m_k; }
    double unit() const { return m_unit; }
    /// Returns half the side of the working volume, mm.
    double halfVolume() const { return m_unit * limit; }
    double minDetail() const { return m_unit * minDetailUnits; }

    /// Converts a point to lattice units. Precondition: p is on the lattice. The result is exact.
    LatticePoint toLattice(const Vec3f& p) const { return (p * static_cast<float>(m_perUnit)).cast<int>(); }
    Vec3f toPoint(const LatticePoint& p) const { return p.cast<float>() * static_cast<float>(m_unit); }

    /// Returns the nearest lattice point, coordinate by coordinate (ties to even). Does not clamp: see contains().
    Vec3f snap(const Vec3& p) const
    {
        return {static_cast<float>(snap(p.x())), static_cast<float>(snap(p.y())), static_cast<float>(snap(p.z()))};
    }
    double snap(double x) const { return roundToEven(x * m_perUnit) * m_unit; }
    bool contains(const Vec3& p) const { return p.cwiseAbs().maxCoeff() <= halfVolume(); }
    bool isOnLattice(const Vec3f& p) const;

    friend bool operator==(const Lattice& a, const Lattice& b) { return a.m_k == b.m_k; }

private:
    /// Rounds as std::nearbyint, but inline: adding 1.5 x 2^52 pushes the fraction out of a double's mantissa.
    static double roundToEven(double x)
    {
        constexpr double shift = 6755399441055744.0;
        return std::abs(x) < shift / 4 ? (x + shift) - shift : x;
    }

    int m_k;
    double m_unit;
    double m_perUnit;
};
} // namespace core
