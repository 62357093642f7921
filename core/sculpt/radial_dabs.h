#pragma once

#include "core/sculpt/copy/patch_copy.h"
#include "core/sculpt/mirrored_dab.h"
#include "core/sculpt/sector_grabs.h"

namespace core
{
/// Applies a dab in every sector of a radially symmetric stroke. The sectors are equal angles about the Y axis. In each
/// sector the dab is also mirrored if the stroke has a mirror plane.
class RadialDabs
{
public:
    RadialDabs(VerifiedMesh& surface, MirroredDab& mirroredDab) : m_surface(surface), m_mirroredDab(mirroredDab) {}

    /// Applies the dab in all sectors. Precondition: a stroke is open.
    DabReport apply(DabRequest& request, const Dab& dab, SectorGrabs& grabs);

private:
    struct Orbit;
    bool addsSolids(const DabRequest& request, const Dab& dab, Region& scratch) const;
    DabReport applyInOrbit(Orbit& orbit);
    DabReport applyInSector(Orbit& orbit, std::size_t sector);
    bool canCopyPatch(const Orbit& orbit, const std::vector<std::size_t>& others);
    bool copyPatch(Orbit& orbit, std::size_t other, const Turn& turn, const DabReport& once, DabReport& report);
    static void separate(Orbit& orbit, std::size_t from, const GrabSnapshot& snapshot);

    VerifiedMesh& m_surface;
    MirroredDab& m_mirroredDab;
    PatchCopy m_patchCopy;
};
} // namespace core
