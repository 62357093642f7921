#include "core/lesson/model_facts.h"

#include "core/analysis/nesting.h"
#include "core/geometry/face_geometry.h"
#include "core/print/print_check.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core
{
namespace
{
constexpr double footShare = 0.01;   ///< fraction of the height between two cuts that look for feet
constexpr int cuts = 10;             ///< number of cuts that look for feet
constexpr double grooveShare = 0.01; ///< smallest depth of a groove as a fraction of the height
constexpr std::size_t levels = 64;

/// Returns the corners of the convex hull of points in a plane, in order (Andrew's monotone chain).
std::vector<Eigen::Vector2d> hullOf(std::vector<Eigen::Vector2d> points)
{
    std::ranges::sort(points, {}, [](const Eigen::Vector2d& p) { return std::pair(p.x(), p.y()); });
    std::vector<Eigen::Vector2d> hull;
    const auto add = [&](const Eigen::Vector2d& p, std::size_t kept) {
        const auto turnsLeft = [&] {
            const Eigen::Vector2d a = hull.back() - hull[hull.size() - 2], b = p - hull.back();
            return a.x() * b.y() - a.y() * b.x() > 0;
        };
        while (hull.size() > kept && !turnsLeft())
            hull.pop_back();
        hull.push_back(p);
    };
    for (const Eigen::Vector2d& p : points)
        add(p, 1);
    const std::size_t lower = hull.size();
    for (std::size_t i = points.size(); i > 1; --i)
        add(points[i - 2], lower);
    return hull;
}

/// Returns for each level the surface's largest distance from the vertical axis of the box.
std::vector<double> outlineOf(const TriangleMesh& mesh, const Box& box)
{
    const Vec3 middle = box.center();
    const double bottom = box.min().y(), spacing = box.sizes().y() / (levels + 1);
    std::vector<double> outline(levels, 0);
    const auto cut = [&](const Vec3& low, const Vec3& high) {
        const double first = std::ceil((low.y() - bottom) / spacing), last = std::floor((high.y() - bottom) / spacing);
        for (double level = std::max(first, 1.0); level <= std::min(last, double(levels)); ++level) {
            const double share = (bottom + level * spacing - low.y()) / std::max(high.y() - low.y(), 1e-12);
            const Vec3 at = low + std::clamp(share, 0.0, 1.0) * (high - low);
            double& radius = outline[static_cast<std::size_t>(level) - 1];
            radius = std::max(radius, std::hypot(at.x() - middle.x(), at.z() - middle.z()));
        }
    };
    for (Slot f = 0; f < mesh.triangles.size(); ++f) {
        const auto corners = cornersOf(mesh, f);
        // Only one of an edge's two faces traverses it upwards, so each edge is cut once.
        for (std::size_t i = 0; i < 3; ++i)
            if (const Vec3& from = corners[i], &to = corners[(i + 1) % 3]; from.y() < to.y())
                cut(from, to);
    }
    return outline;
}
} // namespace

double widestOf(const TriangleMesh& mesh)
{
    std::vector<Eigen::Vector2d> fromAbove;
    fromAbove.reserve(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        for (const Slot v : t)
            fromAbove.emplace_back(mesh.points[v].x(), mesh.points[v].z());
    const std::vector<Eigen::Vector2d> hull = hullOf(std::move(fromAbove));
    double longest = 0;
    for (std::size_t i = 0; i < hull.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            longest = std::max(longest, (hull[i] - hull[j]).squaredNorm());
    return std::sqrt(longest);
}

std::size_t feetOf(const TriangleMesh& mesh)
{
    const Box box = boxOf(mesh);
    if (box.isEmpty())
        return 0;
    std::size_t feet = 0;
    for (int i = 1; i <= cuts; ++i) {
        const double cut = box.min().y() + i * footShare * box.sizes().y();
        std::vector<Triangle> low;
        std::ranges::copy_if(mesh.triangles, std::back_inserter(low), [&](const Triangle& t) {
            return std::ranges::any_of(t, [&](Slot v) { return static_cast<double>(mesh.points[v].y()) <= cut; });
        });
        feet = std::max(feet, componentsOf(mesh.points.size(), low).count);
    }
    return feet;
}

double baseAreaOf(const TriangleMesh& mesh, const MeshReport& report)
{
    return checkForPrint({mesh, report, {}}, {}).baseArea;
}

std::size_t groovesOf(const TriangleMesh& mesh)
{
    const Box box = boxOf(mesh);
    if (box.isEmpty() || box.sizes().y() <= 0)
        return 0;
    const std::vector<double> outline = outlineOf(mesh, box);
    const double depth = grooveShare * box.sizes().y();
    std::size_t grooves = 0;
    double widest = 0, narrowest = 0;
    for (const double radius : outline) {
        narrowest = std::min(narrowest, radius);
        if (narrowest <= widest - depth && radius >= narrowest + depth) {
            ++grooves;
            widest = narrowest = radius;
        } else if (radius >= widest) {
            widest = narrowest = radius;
        }
    }
    return grooves;
}
} // namespace core
