#include "core/repair/mask_transfer.h"

#include <algorithm>

namespace core::repair
{
namespace
{
struct MaskedPlace
{
    Vec3f point;
    std::uint8_t mask;
};

bool liesBefore(const Vec3f& a, const Vec3f& b)
{
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// Returns the masked positions in ascending order, each once.
std::vector<MaskedPlace> maskedPlaces(const TriangleMesh& mesh, const LatticePlacement& placement)
{
    std::vector<MaskedPlace> places;
    for (std::size_t v = 0; v < mesh.masks.size(); ++v) {
        if (mesh.masks[v] > 0)
            places.push_back({placement.lattice.toPoint(placement.toLattice(mesh.points[v])), mesh.masks[v]});
    }
    std::ranges::sort(places, [](const MaskedPlace& a, const MaskedPlace& b) {
        return liesBefore(a.point, b.point) || (a.point == b.point && a.mask > b.mask);
    });
    const auto doubles =
        std::ranges::unique(places, [](const MaskedPlace& a, const MaskedPlace& b) { return a.point == b.point; });
    places.erase(doubles.begin(), doubles.end());
    return places;
}
} // namespace

std::size_t transferMasks(const TriangleMesh& old, const LatticePlacement& placement, TriangleMesh& repaired)
{
    const std::vector<MaskedPlace> places = maskedPlaces(old, placement);
    if (places.empty())
        return 0;
    repaired.masks.assign(repaired.points.size(), 0);
    std::vector<bool> isKept(places.size(), false);
    for (std::size_t v = 0; v < repaired.points.size(); ++v) {
        const auto found = std::ranges::lower_bound(places, repaired.points[v], liesBefore, &MaskedPlace::point);
        if (found == places.end() || found->point != repaired.points[v])
            continue;
        repaired.masks[v] = found->mask;
        isKept[static_cast<std::size_t>(found - places.begin())] = true;
    }
    return static_cast<std::size_t>(std::ranges::count(isKept, false));
}
} // namespace core::repair
