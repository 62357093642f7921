#pragma once

#include "core/geometry/lattice.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

/// Points where lines and planes through lattice points meet, and exact tests of them. A point is rational: homogeneous
/// integers in lowest terms, so that equal points have equal numbers. The nearest doubles are stored too; they decide
/// nearly every test (a filter in the manner of Shewchuk 1997).
namespace core::repair
{
using Integer = boost::multiprecision::cpp_int;

struct ExactPoint
{
    std::array<Integer, 3> numerator;
    Integer denominator = 1;    ///< always positive
    Vec3 approx = Vec3::Zero(); ///< in lattice units, with an error of at most approxError in each coordinate

    /// Bound for |coordinate| <= 2^23: two conversions that may truncate, and a division.
    static constexpr double approxError = 0x1p-27;

    ExactPoint() = default;
    explicit ExactPoint(const LatticePoint& p);
    /// The numbers may have any sign and common factors. Precondition: the denominator is not 0.
    ExactPoint(std::array<Integer, 3> ofNumerator, Integer ofDenominator);

    LatticePoint rounded() const { return approx.array().round().cast<int>(); }
    friend bool operator==(const ExactPoint& a, const ExactPoint& b)
    {
        return a.approx == b.approx && a.numerator == b.numerator && a.denominator == b.denominator;
    }
};

/// A list of points without duplicates.
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

/// The two axes that remain without `axis`, in the order that keeps the sign of LatticePredicates::orient2d.
struct Projection
{
    explicit Projection(int axis) : i(axis == 2 ? 0 : axis + 1), j(axis == 0 ? 2 : axis - 1) {}
    int i, j;
};

/// Returns the sign of the area of abc in the projection.
int orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, Projection onto);
/// Returns the sign of a - b along the axis.
int compare(const ExactPoint& a, const ExactPoint& b, int axis);

/// Returns the point where the line ab meets the plane through the triangle. Precondition: they are not parallel.
ExactPoint lineThroughPlane(const LatticePoint& a, const LatticePoint& b, const std::array<LatticePoint, 3>& plane);
/// Returns the point where the lines ab and cd meet. Precondition: they are in one plane and not parallel in the
/// projection.
ExactPoint linesCrossing(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d,
                         Projection onto);
ExactPoint centroid(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
} // namespace core::repair
