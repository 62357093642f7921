#include "core/repair/exact_point.h"

#include "core/geometry/predicates.h"

#include <cmath>

namespace core::repair
{
namespace
{
/// Error of the difference of two approximations, if |difference| <= 2^24: twice their error and a rounding.
constexpr double differenceError = 3 * ExactPoint::approxError;

/// Returns twice the area of abc in the projection, times the three denominators.
Integer area(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, Projection onto)
{
    const auto& [i, j] = onto;
    return a.numerator[i] * (b.numerator[j] * c.denominator - b.denominator * c.numerator[j]) -
           a.numerator[j] * (b.numerator[i] * c.denominator - b.denominator * c.numerator[i]) +
           a.denominator * (b.numerator[i] * c.numerator[j] - b.numerator[j] * c.numerator[i]);
}

double quotient(const Integer& numerator, const Integer& denominator)
{
    // Numerator and denominator may exceed the range of a double, so bits beyond its precision are dropped first.
    constexpr std::size_t enough = 900;
    const std::size_t bits = numerator == 0 ? 0 : msb(abs(numerator)), below = msb(denominator);
    const std::size_t longest = std::max(bits, below);
    if (longest <= enough)
        return numerator.convert_to<double>() / denominator.convert_to<double>();
    const std::size_t cut = longest - enough;
    return Integer(numerator >> cut).convert_to<double>() / Integer(denominator >> cut).convert_to<double>();
}
} // namespace

ExactPoint::ExactPoint(const LatticePoint& p) : numerator{p.x(), p.y(), p.z()}, approx(p.cast<double>()) {}

ExactPoint::ExactPoint(std::array<Integer, 3> ofNumerator, Integer ofDenominator)
    : numerator(std::move(ofNumerator))
    , denominator(std::move(ofDenominator))
{
    Integer common = denominator;
    for (const Integer& n : numerator) {
        if (common == 1)
            break;
        common = gcd(common, n);
    }
    common = abs(common);
    if (denominator < 0)
        common = -common;
    if (common != 1) {
        for (Integer& n : numerator)
            n /= common;
        denominator /= common;
    }
    for (int axis = 0; axis < 3; ++axis)
        approx[axis] = quotient(numerator[axis], denominator);
}

Slot ExactPoints::add(ExactPoint point)
{
    std::size_t hash = 0;
    for (const double x : point.approx)
        hash = (hash ^ std::hash<double>()(x + 0.0)) * 0x9e3779b97f4a7c15u; // + 0.0 turns -0 into 0
    const auto [first, last] = m_byHash.equal_range(hash);
    for (auto found = first; found != last; ++found) {
        if (m_points[found->second] == point)
            return found->second;
    }
    m_points.push_back(std::move(point));
    m_byHash.emplace(hash, static_cast<Slot>(m_points.size() - 1));
    return static_cast<Slot>(m_points.size() - 1);
}

int orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, Projection onto)
{
    const auto& [i, j] = onto;
    const double bi = b.approx[i] - a.approx[i], bj = b.approx[j] - a.approx[j];
    const double ci = c.approx[i] - a.approx[i], cj = c.approx[j] - a.approx[j];
    const double p = bi * cj, q = bj * ci;
    const double bound = differenceError * (std::abs(bi) + std::abs(bj) + std::abs(ci) + std::abs(cj) + 1) +
                         0x1p-51 * (std::abs(p) + std::abs(q));
    if (std::abs(p - q) > bound)
        return signOf(p - q);
    return area(a, b, c, onto).sign();
}

int compare(const ExactPoint& a, const ExactPoint& b, int axis)
{
    const double difference = a.approx[axis] - b.approx[axis];
    if (std::abs(difference) > differenceError)
        return signOf(difference);
    return Integer(a.numerator[axis] * b.denominator - b.numerator[axis] * a.denominator).sign();
}

ExactPoint lineThroughPlane(const LatticePoint& a, const LatticePoint& b, const std::array<LatticePoint, 3>& plane)
{
    using Wide = Eigen::Matrix<std::int64_t, 3, 1>;
    const auto wide = [](const LatticePoint& p) { return Wide(p.cast<std::int64_t>()); };
    const Wide u = wide(plane[1]) - wide(plane[0]), v = wide(plane[2]) - wide(plane[0]);
    const Wide normal = u.cross(v), toA = wide(a) - wide(plane[0]), toB = wide(b) - wide(plane[0]);
    Integer atA = 0, atB = 0; // signed distances from the plane, with a common factor
    for (int axis = 0; axis < 3; ++axis) {
        atA += Integer(normal[axis]) * toA[axis];
        atB += Integer(normal[axis]) * toB[axis];
    }
    std::array<Integer, 3> numerator;
    for (int axis = 0; axis < 3; ++axis)
        numerator[axis] = a[axis] * atB - b[axis] * atA;
    return {std::move(numerator), atB - atA};
}

ExactPoint linesCrossing(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d,
                         Projection onto)
{
    const Integer atA = area(c, d, a, onto), atB = area(c, d, b, onto);
    std::array<Integer, 3> numerator;
    for (int axis = 0; axis < 3; ++axis)
        numerator[axis] = a.numerator[axis] * atB - b.numerator[axis] * atA;
    return {std::move(numerator), a.denominator * atB - b.denominator * atA};
}

ExactPoint centroid(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c)
{
    std::array<Integer, 3> numerator;
    const Integer bc = b.denominator * c.denominator, ca = c.denominator * a.denominator,
                  ab = a.denominator * b.denominator;
    for (int axis = 0; axis < 3; ++axis)
        numerator[axis] = a.numerator[axis] * bc + b.numerator[axis] * ca + c.numerator[axis] * ab;
    return {std::move(numerator), 3 * a.denominator * bc};
}
} // namespace core::repair
