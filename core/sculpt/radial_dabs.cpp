// Applies a dab in all sectors about the Y axis. Sectors that differ by quarter or half turns form an orbit. The first
// dab of an orbit is applied like any other dab. Each further dab of the orbit is either
//   copied   the patch in its sector is replaced, bit for bit, by the turned patch of the first dab   (copy/patch_copy)
//   redone   if it cannot be copied: the surface is not symmetric under the turn, or the patches overlap
// Orbits are processed one after the other. Each sector has its own grabs (sector_grabs).

#include "core/sculpt/radial_dabs.h"

#include "core/sculpt/add_solid.h"
#include "core/sculpt/select/selector.h"
#include "core/util/phase_timer.h"

namespace core
{
/// One orbit: the sectors first, first + step, first + 2 step, ..., and the data that processing them shares.
struct RadialDabs::Orbit
{
    DabRequest& request;
    SectorGrabs& grabs;
    std::span<const Dab> dabs;     ///< dabs of all sectors, those of other orbits included
    std::span<const Dab> previous; ///< dabs of the orbits that are done already
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

/// Returns the orbit's sectors except the first, and except those whose dab would only repeat another dab (isAmong()).
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

/// Returns the balls in which the orbit's first dab and its mirror image select vertices.
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
    grabs.in(0, settings.tool); // drops the vertices that the dabs of other sectors have removed
    return report;
}

/// Returns whether the dab adds a solid (wantsSolid()). Unless solids join the model, apply() adds them in all sectors
/// or in none. `scratch`: is overwritten.
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
        // a skipped dab repeats another sector's dab, but the result need not be symmetric under the turn between the
        // two
        others.size() + 1 < orbit.dabs.size() / orbit.step;
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

/// Returns whether the patch can be copied to all the given sectors. It is copied to all or to none: with a mirror
/// plane, the patches of two mirrored sectors must be made in the same way.
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

/// Repeats the first dab's change in another sector by a turned copy of its patch. `other`: index of that sector in the
/// list given to canCopyPatch(). `turn`: takes the orbit's first sector to it. Returns false, with nothing changed, if
/// the result would not verify.
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

/// Gives the orbit's sectors from `from` on grabs of their own, for the rest of the stroke.
void RadialDabs::separate(Orbit& orbit, std::size_t from, const GrabSnapshot& snapshot)
{
    for (std::size_t sector = from; sector < orbit.dabs.size(); sector += orbit.step)
        orbit.grabs.separate(sector, snapshot, orbit.turnTo(sector), orbit.request.settings.symmetry);
}
} // namespace core
