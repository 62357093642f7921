#include "core/sculpt/layer_heights.h"

#include <algorithm>

namespace core
{
void LayerHeights::clear()
{
    m_vertices.clear();
    m_heights.clear();
}

void LayerHeights::recall(Region& region, const Mesh& mesh) const
{
    region.forEach([&](Slot v) { region.setCarried(v, of(v) < 0 ? meanAround(v, mesh) : of(v)); });
}

void LayerHeights::note(const Region& region, double share, MirrorMap* mirror)
{
    for (Slot v : region.slots()) {
        const bool isThere = region.contains(v);
        const double height = isThere ? region.carried(v) + share * region.plan(v).norm() : -1;
        set(v, height);
        if (const Slot image = mirror && isThere ? mirror->imageOf(v) : noSlot; image != noSlot)
            set(image, height);
    }
}

void LayerHeights::set(Slot v, double height)
{
    const Slot i = m_vertices.add(v);
    m_heights.resize(m_vertices.size());
    m_heights[i] = height;
}

double LayerHeights::of(Slot v) const
{
    const Slot i = m_vertices.find(v);
    return i == noSlot ? -1 : m_heights[i];
}

/// Returns the mean height of the neighbours whose height is known, or 0.
double LayerHeights::meanAround(Slot v, const Mesh& mesh) const
{
    double sum = 0;
    int known = 0;
    mesh.forEachOutgoing(v, [&](Slot h) {
        const double beside = of(mesh.to(h));
        sum += std::max(beside, 0.0);
        known += beside < 0 ? 0 : 1;
    });
    return known > 0 ? sum / known : 0;
}
} // namespace core
