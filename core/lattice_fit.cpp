#include "lattice_fit.h"

namespace core
{
namespace
{
/// Farther from the origin than this many times its size, a model is moved there.
constexpr double farPerSize = 4;
} // namespace

LatticeFit fitToLattice(const TriangleMesh& model, Placing placing)
{
    Box box;
    for (const Vec3f& p : model.points)
        box.extend(p.cast<double>());
    LatticeFit fit;
    const Vec3 center = box.center();
    const bool far = center.norm() > farPerSize * box.sizes().maxCoeff();
    if (placing == Placing::Centre || (placing == Placing::IfFar && far)) {
        // A multiple of a lattice unit, so that a model that is on a lattice stays as it is.
        const Lattice finest = Lattice::forExtent(0.5 * box.sizes().maxCoeff());
        fit.moved = -Vec3(finest.snap(center.x()), finest.snap(center.y()), finest.snap(center.z()));
    }
    const Vec3 largest = (box.min() + fit.moved).cwiseAbs().cwiseMax((box.max() + fit.moved).cwiseAbs());
    fit.lattice = Lattice::forExtent(largest.maxCoeff());
    fit.mesh = model;
    fit.exact = true;
    for (Vec3f& p : fit.mesh.points) {
        const Vec3 moved = p.cast<double>() + fit.moved;
        p = fit.lattice.snap(moved);
        fit.exact = fit.exact && p.cast<double>() == moved;
    }
    return fit;
}
} // namespace core
