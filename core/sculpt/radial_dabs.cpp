// A dab in several sectors about the Y axis. Sectors that lie to each other by quarter or half turns are an orbit. Its
// first dab is done as any other, and then
//   copied     to the other sectors: its patch is exchanged there for the turned copy, bit for bit      copy/patch_copy
//   or redone  where that cannot be: the surface is not its own image there, or the patches meet
// Orbits are done one after the other. Each sector has grabs of its own.                                sector_grabs

#include "core/sculpt/radial_dabs.h"

#include "core/sculpt/add_solid.h"
#include "core/sculpt/select/selector.h"
#include "core/util/phase_timer.h"

namespace core
{
/// The dabs of an orbit, and what they share. Its sectors are `first`, and each `step` on.
struct RadialDabs::Orbit
{
    DabRequest& request;
    SectorGrabs& grabs;
    std::span<const Dab> dabs;     ///< dabs of all sectors
    std::span<const Dab> previous; ///< dabs of the orbits before
    std::size_t first, step;
    bool addsSolids;

    bool isSingle() const { return step == dabs.size(); }
    Turn turnTo(std::size_t sector) const
    {
        return Turn::part(static_cast<int>(sector - first), static_cast<int>(dabs.size()));
    }
    std::vector<std::size_t> others() const;
    std::vector<Sphere> firstBalls() const;
};

/// Returns the orbit's sectors except the first, and except those whose dab does what another does.
std::vector<std::size_t> RadialDabs::Orbit::others() const
{
    std::vector<Dab> done(previous.begin(), previous.end());
    done.push_back(dabs[first]);
    std::vector<std::size_t> others;
    for (std::size_t sector = first + step; sector < dabs.size(); sector += step) {
        if (isAmong(done, dabs[sector], request.settings, addsSolids))
            continue;
        done.push_back(dabs[sector]);
        others.push_back(sector);
    }
    return others;
}

/// Returns the balls in which the first dab selects.
std::vector<Sphere> RadialDabs::Orbit::firstBalls() const
{
    StrokeSettings inSector = request.settings;
    inSector.radial = 1;
    std::vector<Sphere> balls;
    for (const Vec3& place : imagesOf(dabs[first].position, inSector))
        balls.push_back({place, dabs[first].radius});
    return balls;
}

DabReport RadialDabs::apply(DabRequest& request, const Dab& dab, SectorGrabs& grabs)
{
    const StrokeSettings& settings = request.settings;
    DabReport report;
    const bool adds = addsSolids(request, dab, grabs.first().own.region);
    const bool joins = settings.join && settings.fusion;
    report.refusal =
        adds && !joins ? refusalOf(m_surface, imagesOf(dab.position, settings), dab.radius) : Refusal::None;
    if (report.refusal != Refusal::None) {
        report.outcome = DabOutcome::Refused;
        return report;
    }
    const std::vector<Dab> dabs = sectorDabs(settings, dab);
    const std::size_t exact = static_cast<std::size_t>(exactTurns(settings.radial)), orbits = dabs.size() / exact;
    grabs.setSectors(dabs.size());
    for (std::size_t first = 0; first < orbits; ++first) {
        std::vector<Dab> done;
        for (std::size_t k = 0; k < dabs.size(); ++k) {
            if (k % orbits < first)
                done.push_back(dabs[k]);
        }
        if (isAmong(done, dabs[first], settings, adds))
            continue;
        Orbit orbit = {request, grabs, dabs, done, first, orbits, adds};
        const DabReport all = applyInOrbit(orbit);
        if (first == 0)
            report = all;
        else
            report += all;
        report.sequential = exact == dabs.size() && all.sequential;
    }
    grabs.in(0, settings.tool); // without what the other sectors' dabs have removed
    return report;
}

/// Whether the dab finds nothing under its brush and adds a solid: then it does so in all sectors, or in none.
bool RadialDabs::addsSolids(const DabRequest& request, const Dab& dab, Region& scratch) const
{
    const StrokeSettings& settings = request.settings;
    if (!settings.add || !canAddSolid(settings.tool))
        return false;
    std::vector<Slot> candidates;
    const Selector selector(m_surface.mesh(), m_surface.octree());
    selector.select(scratch, candidates, settings.brush, {dab.position, dab.radius});
    return wantsSolid(m_surface, settings, dab, scratch);
}

DabReport RadialDabs::applyInOrbit(Orbit& orbit)
{
    if (orbit.isSingle())
        return applyInSector(orbit, orbit.first);
    const StrokeSettings& settings = orbit.request.settings;
    const Dab& firstDab = orbit.dabs[orbit.first];
    const bool keeps = keepsSelection(settings.tool);
    const GrabPair& grabs = orbit.grabs.in(orbit.first, settings.tool);
    const bool isGrabbed = keeps && grabs.own.state.isOn;
    const GrabSnapshot snapshot = isGrabbed ? orbit.grabs.snapshot(grabs, firstDab, settings.symmetry) : GrabSnapshot();
    const Mesh::Mark mark = m_surface.mesh().remember();
    DabReport report = applyInSector(orbit, orbit.first);
    const DabReport once = report;
    const std::vector<std::size_t> others = orbit.others();
    bool match = false;
    {
        const PhaseTimer timer(report.selectMs);
        m_patchCopy.learn(m_surface, mark, isGrabbed ? std::vector<Sphere>() : orbit.firstBalls());
        m_surface.mesh().forget(mark);
        match = canCopyPatch(orbit, others);
    }
    report.sequential =
        others.size() + 1 < orbit.dabs.size() / orbit.step; // the rest do the same, and yet are not exact images
    for (std::size_t i = 0; i < others.size(); ++i) {
        if (match && copyPatch(orbit, i, orbit.turnTo(others[i]), once, report))
            continue;
        match = match && !keeps;
        if (keeps && !orbit.grabs.isSeparate(others[i]))
            separate(orbit, others[i], snapshot);
        report += applyInSector(orbit, others[i]);
        report.sequential = true;
    }
    return report;
}

DabReport RadialDabs::applyInSector(Orbit& orbit, std::size_t sector)
{
    return m_mirroredDab.apply(orbit.request, orbit.dabs[sector], orbit.grabs.in(sector, orbit.request.settings.tool));
}

/// To all others or to none: what a plane mirrors besides comes in pairs of sectors.
bool RadialDabs::canCopyPatch(const Orbit& orbit, const std::vector<std::size_t>& others)
{
    std::vector<Turn> turns;
    for (std::size_t sector : others) {
        if (orbit.grabs.isSeparate(sector))
            return false;
        turns.push_back(orbit.turnTo(sector));
    }
    return m_patchCopy.match(m_surface, turns);
}

/// Does in another sector, the image of the orbit's first by `turn`, what the first dab did. `other`: an index of what
/// canCopyPatch() has found. False if the result would not be sound: then nothing has changed.
bool RadialDabs::copyPatch(Orbit& orbit, std::size_t other, const Turn& turn, const DabReport& once, DabReport& report)
{
    {
        const PhaseTimer timer(report.deformMs, m_surface.verifyMs());
        if (!m_patchCopy.place(m_surface, other))
            return false;
    }
    orbit.grabs.dropRemoved();
    StrokeDisplacements& displacements = orbit.request.displacements;
    for (Slot v : m_patchCopy.vertices()) {
        const std::optional<Vec3> displacement = displacements.of(v);
        if (const Slot image = m_patchCopy.imageOf(v); displacement && image != noSlot)
            displacements.set(image, turn * *displacement);
    }
    DabReport copy = once;
    copy.selectMs = copy.optimiseMs = copy.deformMs = copy.fuseMs = 0;
    report += copy;
    if (orbit.request.afterSubstep && !m_patchCopy.isNothing())
        orbit.request.afterSubstep();
    return true;
}

/// From this sector on, the orbit's sectors have grabs of their own.
void RadialDabs::separate(Orbit& orbit, std::size_t from, const GrabSnapshot& snapshot)
{
    for (std::size_t sector = from; sector < orbit.dabs.size(); sector += orbit.step)
        orbit.grabs.separate(sector, snapshot, orbit.turnTo(sector), orbit.request.settings.symmetry);
}
} // namespace core
