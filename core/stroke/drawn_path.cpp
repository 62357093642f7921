#include "core/stroke/drawn_path.h"

#include <algorithm>
#include <utility>

namespace core
{
namespace
{
double distanceToLine(const Vec3& p, const Vec3& from, const Vec3& to)
{
    const Vec3 way = to - from;
    const double squared = way.squaredNorm();
    const double share = squared > 0 ? std::clamp((p - from).dot(way) / squared, 0.0, 1.0) : 0;
    return (p - from - share * way).norm();
}
} // namespace

std::vector<std::size_t> simplifiedPath(const std::vector<Vec3>& path, double tolerance)
{
    if (path.empty())
        return {};
    std::vector<bool> isKept(path.size(), false);
    isKept.front() = isKept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, path.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t farthest = first;
        double most = tolerance;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double away = distanceToLine(path[i], path[first], path[last]);
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
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < path.size(); ++i)
        if (isKept[i])
            kept.push_back(i);
    return kept;
}
} // namespace core
