#include "core/geometry/lattice_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core
{
namespace
{
constexpr double farthestInSizes = 4;
/// A lattice is kept if its exponent differs by at most this from the exponent that an import would choose. An import
/// leaves room for at least 8 times the model; a kept lattice has a quarter to four times that room.
constexpr int maxStepsOff = 2;
constexpr double minStepsPerEdge = 32;

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

double floatStepsPerEdge(const Box& box, double area, std::size_t faces)
{
    const auto largest = static_cast<float>(largestCoordinate(box));
    const double step = std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest;
    return std::sqrt(4 / std::sqrt(3.0) * area / static_cast<double>(faces)) / step; // mean edge of equilateral faces
}

bool isTooFarForFloats(const Box& box, double area, std::size_t faces)
{
    return isFarFromOrigin(box) && faces > 0 && floatStepsPerEdge(box, area, faces) < minStepsPerEdge;
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
