#pragma once

#include "core/geometry/lattice.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

/// Points where lines and planes through lattice points meet, and exact questions about them. They are rational: kept
/// as homogeneous integers in lowest terms, so that equal points have equal numbers, with the nearest doubles beside
/// them, which answer nearly every question (a filter in the manner of Shewchuk 1997).
namespace core::repair
{
using Integer = boost::multiprecision::cpp_int;

struct ExactPoint
{
    std::array<Integer, 3> numerator;
    Integer denominator = 1;    ///< > 0
    Vec3 approx = Vec3::Zero(); ///< lattice units, off by at most approxError in each coordinate

    /// |coordinate| <= 2^23, two conversions that may cut off, and a division.
    static constexpr double approxError = 0x1p-27;

    ExactPoint() = default;
    explicit ExactPoint(const LatticePoint& p);
    /// Of any sign and with common factors; the denominator is not 0.
    ExactPoint(std::array<Integer, 3> ofNumerator, Integer ofDenominator);

    LatticePoint rounded() const { return approx.array().round().cast<int>(); }
    friend bool operator==(const ExactPoint& a, const ExactPoint& b)
    {
        return a.approx == b.approx && a.numerator == b.numerator && a.denominator == b.denominator;
    }
};

/// Each point once.
class ExactPoints
{
public:
    Slot add(ExactPoint point);
    const ExactPoint& operator[](Slot i) const { return m_points[i]; }
    std::size_t size() const { return m_points.size(); }

private:
    std::vector<ExactPoint> m_points;
    std::unordered_multimap<std::size_t, Slot> m_byHash;
};

/// The two axes that remain when `axis` is left out, in the order that keeps LatticePredicates::orient2d's sign.
struct Projection
{
    explicit Projection(int axis) : i(axis == 2 ? 0 : axis + 1), j(axis == 0 ? 2 : axis - 1) {}
    int i, j;
};

/// Sign of the area of abc in the projection.
int orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, Projection onto);
/// Sign of a - b along the axis.
int compare(const ExactPoint& a, const ExactPoint& b, int axis);

/// Where the line ab meets the plane through the triangle; they are not parallel.
ExactPoint lineThroughPlane(const LatticePoint& a, const LatticePoint& b, const std::array<LatticePoint, 3>& plane);
/// Where the lines ab and cd meet, which lie in one plane and are not parallel in the projection.
ExactPoint linesCrossing(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d,
                         Projection onto);
ExactPoint centroid(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
} // namespace core::repair
