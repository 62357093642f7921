#include "core/sculpt/brush_footprint.h"

#include "core/sculpt/deform/dab_weights.h"
#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/select/selector.h"
#include "core/stroke/radial_symmetry.h"

namespace core
{
Footprint BrushFootprint::find(const Mesh& mesh, const FaceOctree& octree, const StrokeSettings& settings,
                               const Vec3& center)
{
    Footprint footprint;
    std::vector<Slot> candidates;
    const Selector selector(mesh, octree);
    const auto add = [&](const Dab& dab) {
        selector.select(m_region, candidates, settings.brush, {dab.position, dab.radius}, Footprint::maxSlots);
        const DabWeights weights(m_region, mesh, settings, dab);
        m_region.forEach([&](Slot v) {
            footprint.slots.push_back(v);
            const double free = settings.tool == Tool::Mask ? 1 : mesh.freedom(v);
            footprint.weights.push_back(static_cast<std::uint8_t>(1 + 254 * free * weights.of(v)));
        });
    };
    Dab dab;
    dab.position = center;
    dab.radius = settings.radius;
    MirrorMap mirror(mesh);
    mirror.setPlane(settings.symmetry);
    for (int k = 0; k < settings.radial; ++k) {
        const Dab inSector = Turn::part(k, settings.radial) * dab;
        add(inSector);
        if (mirror.isOn())
            add(mirror.imageOf(inSector));
    }
    return footprint;
}
} // namespace core
