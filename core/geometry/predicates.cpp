// Computes exact signs for float32 points in the cases that doubles cannot decide.
//
// The determinant of four points, expanded without taking differences, is a sum of 24 signed products of three
// coordinates. In the plane it is a sum of 6 products of two coordinates. ExactSum adds them without rounding.

#include "core/geometry/predicates.h"

#include "core/geometry/exact_sum.h"

#include <utility>

namespace core
{
int FloatPredicates::exactOrient3d(const Point& a, const Point& b, const Point& c, const Point& d)
{
    ExactSum sum;
    sum.addDeterminant(b, c, d, false);
    sum.addDeterminant(a, c, d, true);
    sum.addDeterminant(a, b, d, false);
    sum.addDeterminant(a, b, c, true);
    return sum.sign();
}

int FloatPredicates::exactOrient2d(const Point& a, const Point& b, const Point& c, int axis)
{
    const int i = axis == 2 ? 0 : axis + 1, j = axis == 0 ? 2 : axis - 1;
    ExactSum sum;
    for (const auto& [p, q] : {std::pair{&a, &b}, std::pair{&b, &c}, std::pair{&c, &a}}) {
        sum.add((*p)[i], (*q)[j], 1.0f, false);
        sum.add((*p)[j], (*q)[i], 1.0f, true);
    }
    return sum.sign();
}

int FloatPredicates::Plane::projectionAxis() const
{
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(m_normal[axis]) > detail::roundingBound * m_size[axis])
            return axis;
    for (int axis = 0; axis < 2; ++axis)
        if (m_size[axis] != 0 && exactOrient2d(m_a, m_b, m_c, axis) != 0)
            return axis;
    return 2;
}

bool FloatPredicates::Plane::isPlane() const
{
    return orient2d(m_a, m_b, m_c, projectionAxis()) != 0;
}
} // namespace core
