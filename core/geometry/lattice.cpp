#include "core/geometry/lattice.h"

#include <cassert>

namespace core
{
Lattice Lattice::forExtent(double largestCoordinate)
{
    assert(largestCoordinate > 0 && std::isfinite(largestCoordinate));
    // Condition for k: 8 x largest <= 2^23 u = 2^(23 - k)
    int exponent = 0;
    const double mantissa = std::frexp(8 * largestCoordinate, &exponent); // 8 x largest = mantissa x 2^exponent
    const int ceilLog2 = mantissa == 0.5 ? exponent - 1 : exponent;
    return Lattice(23 - ceilLog2);
}

bool Lattice::isOnLattice(const Vec3f& p) const
{
    for (int i = 0; i < 3; ++i) {
        const double x = static_cast<double>(p[i]) * m_perUnit;
        if (!(std::abs(x) <= limit) || x != std::nearbyint(x))
            return false;
    }
    return true;
}
} // namespace core
