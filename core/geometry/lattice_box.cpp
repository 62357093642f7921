#include "core/geometry/lattice_box.h"

namespace core
{
LatticeBox latticeBox(const Lattice& lattice, const Sphere& ball)
{
    constexpr double limit = Lattice::limit;
    const Eigen::Array3d reach = Eigen::Array3d::Constant(ball.radius);
    const Eigen::Array3d low = (ball.center.array() - reach) / lattice.unit();
    const Eigen::Array3d high = (ball.center.array() + reach) / lattice.unit();
    return {low.floor().max(-limit).min(limit).matrix().cast<int>(),
            high.ceil().max(-limit).min(limit).matrix().cast<int>()};
}
} // namespace core
