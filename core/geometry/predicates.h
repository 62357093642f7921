#pragma once

#include "core/geometry/geometry.h"
#include "core/geometry/lattice.h"

#include <cstdint>

/// Exact geometric tests of points, answered by a sign: -1, 0 or 1. Two classes with one interface, for use in
/// templates: one for lattice points (the engine), one for any float32 points (files).
namespace core
{
template <typename Number> constexpr int signOf(Number x)
{
    return (x > Number(0)) - (x < Number(0));
}

/// Predicates for lattice points. Cost: about 3 ns per test, without loops or branches.
struct LatticePredicates
{
    using Point = LatticePoint;

    /// The oriented plane through three points; cheaper than orient3d when several points are tested against it.
    class Plane
    {
    public:
        Plane(const Point& a, const Point& b, const Point& c);
        /// Returns the sign of ((b-a) x (c-a)) . (d-a): 1 if the triangle winds counter-clockwise as seen from d.
        int side(const Point& d) const;
        /// Returns false if the points are collinear; side() then always returns 0.
        bool isPlane() const;
        /// Returns an axis along which the plane can be projected without becoming a line.
        int projectionAxis() const;

    private:
        Point m_origin;
        std::int64_t m_normal[3];
    };

    static int orient3d(const Point& a, const Point& b, const Point& c, const Point& d)
    {
        return Plane(a, b, c).side(d);
    }

    /// Returns the sign of twice the area of abc projected along `axis`: 1 if it is counter-clockwise as seen from the
    /// positive end of the axis.
    static int orient2d(const Point& a, const Point& b, const Point& c, int axis);

    static bool collinear(const Point& a, const Point& b, const Point& c) { return !Plane(a, b, c).isPlane(); }
};

/// Predicates for finite float32 points of any magnitude, including denormals. Cost: about 5 ns per test, or 0.3 us if
/// rounding could change the sign.
struct FloatPredicates
{
    using Point = Vec3f;

    class Plane
    {
    public:
        Plane(const Point& a, const Point& b, const Point& c);
        int side(const Point& d) const;
        bool isPlane() const;
        int projectionAxis() const;

    private:
        Point m_a, m_b, m_c;
        double m_normal[3];
        /// The normal's components with every term taken as positive: the scale of the rounding error.
        double m_size[3];
    };

    static int orient3d(const Point& a, const Point& b, const Point& c, const Point& d)
    {
        return Plane(a, b, c).side(d);
    }
    static int orient2d(const Point& a, const Point& b, const Point& c, int axis);
    static bool collinear(const Point& a, const Point& b, const Point& c) { return !Plane(a, b, c).isPlane(); }

private:
    static int exactOrient3d(const Point& a, const Point& b, const Point& c, const Point& d);
    static int exactOrient2d(const Point& a, const Point& b, const Point& c, int axis);
};

// Bounds on the lattice. |coordinate| <= 2^23, so a difference is at most 2^24, a product of two 2^48, and a component
// of the normal 2^49. The determinant would need 75 bits. Each component n is therefore split into high 2^25 + low,
// where |high| <= 2^24 and 0 <= low < 2^25: the two sums of three products are at most 3 x 2^48 and 3 x 2^49, and the
// determinant is highSum 2^25 + lowSum. Everything fits an int64 with bits to spare.

inline LatticePredicates::Plane::Plane(const Point& a, const Point& b, const Point& c) : m_origin(a)
{
    const std::int64_t ux = b.x() - a.x(), uy = b.y() - a.y(), uz = b.z() - a.z();
    const std::int64_t vx = c.x() - a.x(), vy = c.y() - a.y(), vz = c.z() - a.z();
    m_normal[0] = uy * vz - uz * vy;
    m_normal[1] = uz * vx - ux * vz;
    m_normal[2] = ux * vy - uy * vx;
}

inline int LatticePredicates::Plane::side(const Point& d) const
{
    constexpr int split = 25;
    constexpr std::int64_t lowMask = (std::int64_t(1) << split) - 1;
    std::int64_t high = 0, low = 0;
    for (int i = 0; i < 3; ++i) {
        const std::int64_t w = d[i] - m_origin[i];
        high += (m_normal[i] >> split) * w;
        low += (m_normal[i] & lowMask) * w;
    }
    high += low >> split; // the rest of low is not negative and below one unit of high
    return high != 0 ? signOf(high) : (low & lowMask) != 0;
}

inline bool LatticePredicates::Plane::isPlane() const
{
    return (m_normal[0] | m_normal[1] | m_normal[2]) != 0;
}

inline int LatticePredicates::Plane::projectionAxis() const
{
    return m_normal[0] != 0 ? 0 : m_normal[1] != 0 ? 1 : 2;
}

inline int LatticePredicates::orient2d(const Point& a, const Point& b, const Point& c, int axis)
{
    const int i = axis == 2 ? 0 : axis + 1, j = axis == 0 ? 2 : axis - 1;
    const std::int64_t ui = b[i] - a[i], uj = b[j] - a[j], vi = c[i] - a[i], vj = c[j] - a[j];
    return signOf(ui * vj - uj * vi);
}

namespace detail
{
/// Bound of the relative rounding error of a 3 x 3 determinant of differences. Each of its terms goes through at most 8
/// roundings of 2^-53 (difference, product, subtraction, product, two sums). The computed value is therefore off by
/// less than 9 x 2^-53 of the sum of the terms' sizes. That sum is itself computed with at most 9 x 2^-53 of error.
/// The factor 16 covers both errors. Products of three differences of float32 numbers are 0 or between 2^-447 and
/// 2^388, so a double neither under- nor overflows.
inline constexpr double roundingBound = 16 * 0x1p-53;
} // namespace detail

inline FloatPredicates::Plane::Plane(const Point& a, const Point& b, const Point& c) : m_a(a), m_b(b), m_c(c)
{
    const Vec3 origin = a.cast<double>(), u = b.cast<double>() - origin, v = c.cast<double>() - origin;
    for (int i = 0; i < 3; ++i) {
        const int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        const double p = u[j] * v[k], q = u[k] * v[j];
        m_normal[i] = p - q;
        m_size[i] = std::abs(p) + std::abs(q);
    }
}

inline int FloatPredicates::Plane::side(const Point& d) const
{
    const Vec3 w = d.cast<double>() - m_a.cast<double>();
    const double det = m_normal[0] * w[0] + m_normal[1] * w[1] + m_normal[2] * w[2];
    const double size = m_size[0] * std::abs(w[0]) + m_size[1] * std::abs(w[1]) + m_size[2] * std::abs(w[2]);
    if (std::abs(det) > detail::roundingBound * size)
        return signOf(det);
    return size == 0 ? 0 : exactOrient3d(m_a, m_b, m_c, d); // size 0: each term has a factor that is exactly 0
}

inline int FloatPredicates::orient2d(const Point& a, const Point& b, const Point& c, int axis)
{
    const int i = axis == 2 ? 0 : axis + 1, j = axis == 0 ? 2 : axis - 1;
    const double ai = a[i], aj = a[j];
    const double p = (b[i] - ai) * (c[j] - aj), q = (b[j] - aj) * (c[i] - ai);
    const double size = std::abs(p) + std::abs(q);
    if (std::abs(p - q) > detail::roundingBound * size)
        return signOf(p - q);
    return size == 0 ? 0 : exactOrient2d(a, b, c, axis);
}
} // namespace core
