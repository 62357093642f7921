#include "core/primitives/tube_path.h"

#include <algorithm>
#include <utility>

namespace core
{
namespace
{
double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 along = b - a;
    const double squared = along.squaredNorm();
    const double share = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
    return (p - a - share * along).norm();
}

std::vector<TubePoint> simplified(const std::vector<TubePoint>& path, double tolerance)
{
    std::vector<bool> isKept(path.size(), false);
    isKept.front() = isKept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, path.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t farthest = first;
        double most = tolerance;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double away = distanceToSegment(path[i].position, path[first].position, path[last].position);
            if (away > most) {
                most = away;
                farthest = i;
            }
        }
        if (farthest == first)
            continue;
        isKept[farthest] = true;
        open.emplace_back(first, farthest);
        open.emplace_back(farthest, last);
    }
    std::vector<TubePoint> result;
    for (std::size_t i = 0; i < path.size(); ++i)
        if (isKept[i])
            result.push_back(path[i]);
    return result;
}
} // namespace

std::vector<TubePoint> thinnedPath(const std::vector<TubePoint>& drawn, double tolerance)
{
    std::vector<TubePoint> path = simplified(drawn, tolerance);
    const TubePoint last = path.back();
    const auto isNear = [](const TubePoint& a, const TubePoint& b) {
        return (a.position - b.position).norm() < a.radius;
    };
    path.erase(std::unique(path.begin(), path.end(), isNear), path.end());
    if (path.back() == last)
        return path;
    if (path.size() > 1 && isNear(path.back(), last))
        path.pop_back();
    path.push_back(last);
    return path;
}
} // namespace core
