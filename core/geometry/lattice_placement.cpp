#include "core/geometry/lattice_placement.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
constexpr double farthestInSizes = 4;
/// An import leaves room for eight times the model; a lattice is kept down to twice, and up to 32 times.
constexpr int maxStepsOff = 2;

double largestCoordinate(const Box& box)
{
    return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}
} // namespace

LatticePoint LatticePlacement::toLattice(const Vec3f& p) const
{
    LatticePoint result;
    for (int i = 0; i < 3; ++i) {
        const double x = std::nearbyint((static_cast<double>(p[i]) + moved[i]) / lattice.unit());
        result[i] = static_cast<int>(std::clamp<double>(x, -Lattice::limit, Lattice::limit));
    }
    return result;
}

bool isFarFromOrigin(const Box& box)
{
    return std::sqrt(box.center().squaredNorm()) > farthestInSizes * box.sizes().maxCoeff();
}

LatticePlacement placeOnLattice(const Box& box, bool centre)
{
    const Vec3 middle = box.center();
    if (!centre && !isFarFromOrigin(box))
        return {Lattice::forExtent(largestCoordinate(box))};
    const Lattice lattice = Lattice::forExtent(box.sizes().maxCoeff() / 2);
    return {lattice, -Vec3(lattice.snap(middle.x()), lattice.snap(middle.y()), lattice.snap(middle.z()))};
}

Lattice latticeFor(const Box& box, const Lattice& present)
{
    const Lattice best = Lattice::forExtent(largestCoordinate(box));
    return std::abs(best.exponent() - present.exponent()) <= maxStepsOff ? present : best;
}
} // namespace core
