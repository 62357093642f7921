#include "core/sculpt/selection_quality.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
/// One face in this number may have a smaller angle than SelectionQuality::smallestAngleSine (1st percentile).
constexpr std::size_t facesPerExcused = 100;

double edgeLength(const Mesh& mesh, Slot a, Slot b)
{
    return (mesh.point(a) - mesh.point(b)).cast<double>().norm();
}

/// Returns the sine of the triangle's smallest angle, the one between its two longest edges; 0 if it is degenerate.
double smallestAngleSine(const Mesh& mesh, const Triangle& t)
{
    const Vec3 a = mesh.point(t[0]).cast<double>(), b = mesh.point(t[1]).cast<double>(),
               c = mesh.point(t[2]).cast<double>();
    std::array<double, 3> length = {(b - a).norm(), (c - b).norm(), (a - c).norm()};
    std::ranges::sort(length);
    const double doubleArea = (b - a).cross(c - a).norm();
    return doubleArea > 0 ? doubleArea / (length[1] * length[2]) : 0;
}
} // namespace

std::optional<SelectionQuality> selectionQuality(const Mesh& mesh, const Region& region, const EdgeBounds& bounds)
{
    SelectionQuality quality;
    std::size_t edges = 0, conforming = 0;
    std::vector<double> sines;
    region.forEach([&](Slot v) {
        mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot other = mesh.to(h);
            if (v < other && region.contains(other)) {
                const double length = edgeLength(mesh, v, other);
                quality.longestEdge = std::max(quality.longestEdge, length / bounds.detail);
                conforming += length >= bounds.minimum;
                ++edges;
            }
            const Triangle& corners = mesh.corners(mesh.face(h));
            if (v == std::ranges::min(corners) &&
                std::ranges::all_of(corners, [&](Slot c) { return region.contains(c); }))
                sines.push_back(smallestAngleSine(mesh, corners));
        });
    });
    if (sines.empty())
        return std::nullopt;
    const auto percentile = sines.begin() + static_cast<std::ptrdiff_t>(sines.size() / facesPerExcused);
    std::ranges::nth_element(sines, percentile);
    quality.smallestAngleSine = *percentile;
    quality.conformingShare = static_cast<double>(conforming) / static_cast<double>(edges);
    return quality;
}
} // namespace core
