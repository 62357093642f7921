#pragma once

#include "face_octree.h"

#include <algorithm>
#include <cmath>

namespace core
{
/// Calls visit(i, j) once for every two boxes that meet, i < `first` or j < `first` (so that pairs among the rest are left out).
/// A sweep along x inside strips along y. Cost: O(n log n + pairs) for boxes of similar size.
template <class Visit> void forEachBoxPair(std::span<const LatticeBox> boxes, Slot first, Visit visit)
{
    LatticeBox all;
    std::int64_t heights = 0;
    for (const LatticeBox& box : boxes) {
        all.extend(box);
        heights += box.max.y() - box.min.y() + 1;
    }
    if (boxes.empty())
        return;
    constexpr std::int64_t boxesPerStrip = 4;
    const std::int64_t stripHeight = std::max<std::int64_t>(1, boxesPerStrip * heights / static_cast<std::int64_t>(boxes.size()));
    const auto strip = [&](int y) { return (static_cast<std::int64_t>(y) - all.min.y()) / stripHeight; };

    struct Entry
    {
        std::int64_t strip;
        int minX;
        Slot box;
    };
    std::vector<Entry> entries;
    entries.reserve(2 * boxes.size());
    for (Slot i = 0; i < boxes.size(); ++i) {
        for (std::int64_t s = strip(boxes[i].min.y()); s <= strip(boxes[i].max.y()); ++s)
            entries.push_back({s, boxes[i].min.x(), i});
    }
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
        return std::tie(a.strip, a.minX, a.box) < std::tie(b.strip, b.minX, b.box);
    });
    for (std::size_t a = 0; a < entries.size(); ++a) {
        const LatticeBox& boxA = boxes[entries[a].box];
        for (std::size_t b = a + 1; b < entries.size(); ++b) {
            if (entries[b].strip != entries[a].strip || entries[b].minX > boxA.max.x())
                break;
            const Slot i = std::min(entries[a].box, entries[b].box), j = std::max(entries[a].box, entries[b].box);
            const LatticeBox& boxB = boxes[entries[b].box];
            // Of the strips that both lie in, only the first reports the pair.
            if (i < first && boxA.meets(boxB) && strip(std::max(boxA.min.y(), boxB.min.y())) == entries[a].strip)
                visit(i, j);
        }
    }
}
} // namespace core
