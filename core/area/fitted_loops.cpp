#include "core/area/fitted_loops.h"

namespace core
{
namespace
{
/// Half the side of the square on the plane lattice into which the curve is fitted.
constexpr double latticeReach = 1 << 20;
} // namespace

FittedLoops::FittedLoops(const std::vector<Eigen::Vector2d>& curve)
{
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : curve)
        box.extend(p);
    if (curve.size() < 3 || box.sizes().maxCoeff() <= 0)
        return;
    m_center = box.center();
    m_unit = box.sizes().maxCoeff() / 2 / latticeReach;
    std::vector<FlatPoint> points;
    for (const Eigen::Vector2d& p : curve)
        points.emplace_back(inUnits(p).array().round().cast<int>());
    m_loops = windingOutline(points);
}
} // namespace core
