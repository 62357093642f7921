#include "core/repair/outward_offset.h"

#include "core/analysis/nesting.h"

#include <Eigen/Eigenvalues>

#include <map>

namespace core::repair
{
namespace
{
/// The planes of a point's faces: weighted sums of n n^T and n over the normals n.
struct PlaneFit
{
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Vec3 sum = Vec3::Zero();
    Slot component = 0;
    double shortestEdge = std::numeric_limits<double>::infinity();

    /// Returns the displacement that moves each plane by about 1. Has no component in directions that the planes hardly
    /// determine.
    Vec3 move() const
    {
        constexpr double least = 0.05; // share of the largest eigenvalue
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
        Vec3 result = Vec3::Zero();
        for (int i = 0; i < 3; ++i) {
            const Vec3 axis = solver.eigenvectors().col(i);
            const double value = solver.eigenvalues()[i];
            if (value > least * solver.eigenvalues()[2])
                result += axis * (axis.dot(sum) / value);
        }
        return result;
    }
};

void addFace(std::map<Slot, PlaneFit>& fits, const std::vector<bool>& isMoved, const TriangleSoup& surface,
             const Triangle& t, Slot component)
{
    // Lattice units. Faces of less height have less weight, because rounding changes their normals.
    constexpr double clearHeight = 64;
    const auto at = [&](Slot v) { return Vec3(surface.points[v].cast<double>()); };
    const Vec3 normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    const double area = normal.norm();
    if (area == 0)
        return;
    const double longest =
        std::max({(at(t[1]) - at(t[0])).norm(), (at(t[2]) - at(t[0])).norm(), (at(t[1]) - at(t[2])).norm()});
    const Vec3 n = normal / area;
    const double weight = std::min(1.0, area / longest / clearHeight);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!isMoved[t[i]])
            continue;
        PlaneFit& fit = fits[t[i]];
        fit.matrix += weight * n * n.transpose();
        fit.sum += weight * n;
        fit.component = component;
        for (const std::size_t k : {i + 1, i + 2})
            fit.shortestEdge = std::min(fit.shortestEdge, (at(t[k % 3]) - at(t[i])).norm());
    }
}
} // namespace

void offsetOutwards(TriangleSoup& surface, std::span<const Slot> points, double distance)
{
    constexpr double farthest = 3, ofShortestEdge = 0.25;
    std::vector<bool> isMoved(surface.points.size(), false);
    for (const Slot v : points)
        isMoved[v] = true;
    const Components components = componentsOf(surface.points.size(), surface.triangles);
    std::map<Slot, PlaneFit> fits;
    for (Slot f = 0; f < surface.triangles.size(); ++f) {
        const Triangle& t = surface.triangles[f];
        if (isMoved[t[0]] || isMoved[t[1]] || isMoved[t[2]])
            addFace(fits, isMoved, surface, t, components.ofFace[f]);
    }
    for (const auto& [v, fit] : fits) {
        const double wanted = distance * (1 + 0.5 * (fit.component % 3));
        const double most = std::min(farthest * wanted, ofShortestEdge * fit.shortestEdge);
        Vec3 move = wanted * fit.move();
        if (const double length = move.norm(); length > most)
            move *= most / length;
        const LatticePoint to = surface.points[v] + LatticePoint(move.array().round().cast<int>());
        surface.points[v] = to.cwiseMax(-Lattice::limit).cwiseMin(Lattice::limit);
    }
}
} // namespace core::repair
