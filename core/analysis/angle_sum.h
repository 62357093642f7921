#pragma once

#include <cmath>
#include <numbers>

namespace core
{
/// Sums the angles of plane vectors, each in (-pi, pi], by multiplying the vectors as complex numbers. Counts whole
/// turns, so that one arc tangent is enough for all.
class AngleSum
{
public:
    void add(double x, double y)
    {
        const double re = m_x * x - m_y * y, im = m_x * y + m_y * x, size = std::abs(re) + std::abs(im);
        if (!(size > 0))
            return;
        const bool wasUpper = isUpper(m_x, m_y), isOtherUpper = isUpper(x, y);
        const bool wasLower = m_y < 0, isOtherLower = y < 0;
        const double scale = size > largest || size < 1 / largest ? 1 / size : 1;
        m_x = scale * re;
        m_y = scale * im;
        if (wasUpper && isOtherUpper && !isUpper(m_x, m_y))
            ++m_turns;
        else if (wasLower && isOtherLower && m_y >= 0)
            --m_turns;
    }
    double value() const { return std::atan2(m_y, m_x) + 2 * std::numbers::pi * m_turns; }

private:
    /// Returns whether the angle of (x, y) is in (0, pi].
    static bool isUpper(double x, double y) { return y > 0 || (y == 0 && x < 0); }

    /// A product that is larger than this, or smaller than its inverse, is scaled before it overflows or vanishes.
    static constexpr double largest = 1e100;

    double m_x = 1, m_y = 0;
    int m_turns = 0;
};
} // namespace core
