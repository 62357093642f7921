#pragma once

#include "core/sculpt/copy/patch_copy.h"
#include "core/sculpt/mirrored_dab.h"
#include "core/sculpt/sector_grabs.h"

namespace core
{
/// A dab in several sectors about the Y axis, each of which may be mirrored, too.
class RadialDabs
{
public:
    RadialDabs(VerifiedMesh& surface, MirroredDab& mirroredDab) : m_surface(surface), m_mirroredDab(mirroredDab) {}

    /// Precondition: a stroke is open.
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
