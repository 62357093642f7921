#include "core/primitives/tube_path.h"

#include "core/stroke/drawn_path.h"

#include <algorithm>

namespace core
{
std::vector<TubePoint> thinnedPath(const std::vector<TubePoint>& drawn, double tolerance)
{
    std::vector<Vec3> places;
    for (const TubePoint& point : drawn)
        places.push_back(point.position);
    std::vector<TubePoint> path;
    for (const std::size_t i : simplifiedPath(places, tolerance))
        path.push_back(drawn[i]);
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
