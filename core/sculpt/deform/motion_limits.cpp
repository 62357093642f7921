#include "core/sculpt/deform/motion_limits.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr double shortenedOnce = 0.25;
} // namespace

void MotionLimits::extend(const Region& region, const Mesh& mesh)
{
    const std::vector<Slot>& slots = region.slots();
    const std::size_t known = m_share.size();
    m_share.resize(slots.size(), 1.0);
    if (known == 0)
        return;
    for (std::size_t i = known; i < slots.size(); ++i) {
        if (!region.contains(slots[i]))
            continue;
        mesh.forEachOutgoing(slots[i], [&](Slot h) {
            if (region.contains(mesh.to(h)))
                m_share[i] = std::min(m_share[i], m_share[region.position(mesh.to(h))]);
        });
    }
}

std::vector<Slot> MotionLimits::tighten(Region& region, const Mesh& mesh, const std::vector<Slot>& badFaces, int rings)
{
    std::vector<Slot> around = cornersOf(mesh, badFaces);
    for (int ring = 0; ring < rings; ++ring)
        around = withNeighbours(region, mesh, around);
    std::erase_if(around, [&](Slot v) {
        double& share = m_share[region.position(v)];
        const double before = share;
        share = before == 1 ? shortenedOnce : 0;
        return before == 0;
    });
    return around;
}
} // namespace core
