// A dab in several sectors about the Y axis. Those that lie to each other by quarter or half turns are an orbit, whose
// first dab is done as always, and then
//   copied        to the others: its patch is exchanged there for the turned copy, bit for bit patch_copy or repeated
//   where that cannot be: the surface is not its own image there, or the patches meet
// Orbits are done one after the other. Each sector has its own grab.

#include "core/sculpt/dab_engine.h"

#include "core/sculpt/add_solid.h"
#include "core/util/phase_timer.h"

#include <utility>

namespace core
{
/// What the dabs of an orbit share.
struct DabEngine::Orbit
{
    const StrokeSettings& settings;
    std::span<const Dab> dabs;   ///< of all sectors
    std::span<const Dab> before; ///< that were done
    std::size_t first;           ///< its sectors: this one, and each `step` on
    std::size_t step;
    const std::function<void()>& between;
    bool adds = false;                                         ///< solids
    GrabState grab = {}, mirroredGrab = {};                    ///< before the first dab; so the next two
    std::vector<GrabbedPoint> grabbed = {}, grabbedImage = {}; ///< `grabbedImage`: none, where a half stands for both
};

void DabEngine::runOnce(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between,
                        DabReport& report)
{
    if (settings.symmetry == Symmetry::None)
        run(settings, dab, between, report);
    else
        runMirrored(settings, dab, between, report);
}

/// Runs the dab with that sector's grab.
DabReport DabEngine::runInSector(const Orbit& orbit, std::size_t sector)
{
    DabReport report;
    swapSector(orbit.settings.tool, sector);
    runOnce(orbit.settings, orbit.dabs[sector], orbit.between, report);
    swapSector(orbit.settings.tool, sector);
    return report;
}

void DabEngine::runRadial(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between,
                          DabReport& report)
{
    const bool adds = addsIn(settings, dab);
    report.refusal = adds ? refusalOf(m_surface, imagesOf(dab.position, settings), dab.radius) : Refusal::None;
    if (report.refusal != Refusal::None) {
        report.outcome = DabOutcome::Refused;
        return;
    }
    const std::vector<Dab> dabs = sectorDabs(settings, dab);
    const std::size_t exact = static_cast<std::size_t>(exactTurns(settings.radial)), orbits = dabs.size() / exact;
    m_sectors.resize(dabs.size());
    for (std::size_t first = 0; first < orbits; ++first) {
        std::vector<Dab> done;
        for (std::size_t k = 0; k < dabs.size(); ++k) {
            if (k % orbits < first)
                done.push_back(dabs[k]);
        }
        Orbit orbit = {settings, dabs, done, first, orbits, between, adds};
        if (isAmong(done, dabs[first], settings, adds))
            continue;
        DabReport all = runOrbit(orbit);
        if (first == 0)
            report = all;
        else
            report += all;
        report.sequential = exact == dabs.size() && all.sequential;
    }
}

/// A dab that finds nothing under its brush adds a solid: in all sectors, where the balls around them have room in all.
bool DabEngine::addsIn(const StrokeSettings& settings, const Dab& dab)
{
    if (!settings.add || !canAddSolid(settings.tool))
        return false;
    select(m_region, m_candidates, settings.brush, {dab.position, dab.radius});
    return wantsSolid(settings, dab);
}

DabReport DabEngine::runOrbit(Orbit& orbit)
{
    if (orbit.step == orbit.dabs.size()) // alone
        return runInSector(orbit, orbit.first);
    const Tool tool = orbit.settings.tool;
    swapSector(tool, orbit.first);
    const bool isGrabbed = keepsSelection(tool) && m_grab.isOn;
    if (isGrabbed)
        noteGrabbed(orbit);
    swapSector(tool, orbit.first);
    const Mesh::Mark mark = m_mesh.remember();
    DabReport report = runInSector(orbit, orbit.first);
    const DabReport once = report;
    const std::vector<std::size_t> others = othersIn(orbit);
    bool match = false;
    {
        const PhaseTimer timer(report.selectMs);
        m_patchCopy.learn(m_surface, mark, isGrabbed ? std::vector<Sphere>() : ballsOf(orbit));
        m_mesh.forget(mark);
        match = canCopyPatch(orbit, others);
    }
    report.sequential =
        others.size() + 1 < orbit.dabs.size() / orbit.step; // the rest do the same, and yet are not exact images
    for (std::size_t i = 0; i < others.size(); ++i) {
        if (match && copyPatch(orbit, i, once, report))
            continue;
        match = match && !keepsSelection(tool);
        grabSeparately(orbit, others[i]);
        report += runInSector(orbit, others[i]);
        report.sequential = true;
    }
    return report;
}

/// Where its first dab selects.
std::vector<Sphere> DabEngine::ballsOf(const Orbit& orbit)
{
    StrokeSettings inSector = orbit.settings;
    inSector.radial = 1;
    std::vector<Sphere> balls;
    const Dab& dab = orbit.dabs[orbit.first];
    for (const Vec3& place : imagesOf(dab.position, inSector))
        balls.push_back({place, dab.radius});
    return balls;
}

/// The orbit's other sectors, but for those that do what another does.
std::vector<std::size_t> DabEngine::othersIn(const Orbit& orbit)
{
    std::vector<Dab> done(orbit.before.begin(), orbit.before.end());
    done.push_back(orbit.dabs[orbit.first]);
    std::vector<std::size_t> others;
    for (std::size_t sector = orbit.first + orbit.step; sector < orbit.dabs.size(); sector += orbit.step) {
        if (isAmong(done, orbit.dabs[sector], orbit.settings, orbit.adds))
            continue;
        done.push_back(orbit.dabs[sector]);
        others.push_back(sector);
    }
    return others;
}

/// To all others or to none: what a plane mirrors besides comes in pairs of sectors.
bool DabEngine::canCopyPatch(const Orbit& orbit, const std::vector<std::size_t>& others)
{
    std::vector<Turn> turns;
    for (std::size_t sector : others) {
        if (m_sectors[sector].isSeparate)
            return false;
        turns.push_back(turnIn(orbit, sector));
    }
    return m_patchCopy.match(m_surface, turns);
}

/// What the orbit's first dab did, in one of those that canCopyPatch() found.
bool DabEngine::copyPatch(const Orbit& orbit, std::size_t other, const DabReport& once, DabReport& report)
{
    {
        const PhaseTimer timer(report.deformMs, m_surface.verifyMs());
        if (!m_patchCopy.place(m_surface, other))
            return false;
    }
    dropRemoved(m_grab, m_region);
    dropRemoved(m_mirroredGrab, m_imageRegion);
    for (SectorGrab& sector : m_sectors) {
        dropRemoved(sector.grab, sector.region);
        dropRemoved(sector.mirroredGrab, sector.imageRegion);
    }
    if (orbit.settings.tool == Tool::Layer) {
        for (Slot v : m_patchCopy.vertices()) {
            if (const Slot image = m_patchCopy.imageOf(v); image != noSlot)
                noteRaised(image, raised(v));
        }
    }
    DabReport copy = once;
    copy.selectMs = copy.optimiseMs = copy.deformMs = copy.fuseMs = 0;
    report += copy;
    if (orbit.between && !m_patchCopy.isNothing())
        orbit.between();
    return true;
}

Turn DabEngine::turnIn(const Orbit& orbit, std::size_t sector)
{
    return Turn::part(static_cast<int>(sector - orbit.first), static_cast<int>(orbit.dabs.size()));
}

/// From now on this sector and those after it have grabs of their own: the first one's before its dab, turned. A dab
/// and its mirror image turn against each other.
void DabEngine::grabSeparately(const Orbit& orbit, std::size_t from)
{
    if (!keepsSelection(orbit.settings.tool) || m_sectors[from].isSeparate)
        return;
    for (std::size_t sector = from; sector < orbit.dabs.size(); sector += orbit.step) {
        SectorGrab& own = m_sectors[sector];
        if (std::exchange(own.isSeparate, true) || !orbit.grab.isOn)
            continue;
        const Turn turn = turnIn(orbit, sector), back = {turn.cosine, -turn.sine};
        const std::size_t known = m_mesh.removedVertices().size();
        if (orbit.grab.isMirrored) {
            grabHalf(orbit, own, turn);
            continue;
        }
        own.grab = {true, false, turn * orbit.grab.axis, orbit.grab.detail, known};
        own.mirroredGrab = {orbit.mirroredGrab.isOn, false, back * orbit.mirroredGrab.axis, orbit.mirroredGrab.detail,
                            known};
        selectImages(own.region, orbit.grabbed, turn);
        selectImages(own.imageRegion, orbit.grabbedImage, back);
    }
}

/// Where a half stood for both sides of the plane, it does so here. A quarter turn takes the plane elsewhere: a whole
/// that was grabbed is halved anew.
void DabEngine::grabHalf(const Orbit& orbit, SectorGrab& own, const Turn& turn)
{
    m_mirror.setPlane(orbit.settings.symmetry);
    const Dab& dab = orbit.dabs[orbit.first];
    const Vec3 at = turn * dab.position, axis = turn * orbit.grab.axis;
    const bool isOver = m_mirror.folded(at) != at; // the half is the image's
    own.grab = {true, true, isOver ? m_mirror.imageOf(axis) : axis, orbit.grab.detail, m_mesh.removedVertices().size()};
    own.mirroredGrab = {};
    own.imageRegion.clear();
    std::vector<GrabbedPoint> whole = orbit.grabbed;
    for (GrabbedPoint& place : whole)
        place.point = isOver ? m_mirror.imageOf(turn * place.point) : turn * place.point;
    own.region.clear();
    for (const GrabbedPoint& place : whole) {
        if (const Slot v = vertexAt(m_surface, place.point); v != noSlot && m_mirror.isInHalf(v))
            own.region.add(v, place.distance, Vec3::Zero(), 2 * dab.radius);
    }
    for (const GrabbedPoint& place : whole) {
        if (const Slot v = vertexAt(m_surface, m_mirror.imageOf(place.point)); v != noSlot && own.region.contains(v))
            own.region.setCarried(v, place.distance);
    }
    m_mirror.setPlane(Symmetry::None);
}

/// Before the orbit's first dab, by place: its own, and its mirror image's where no half stands for both.
void DabEngine::noteGrabbed(Orbit& orbit)
{
    orbit.grab = m_grab;
    orbit.mirroredGrab = m_mirroredGrab;
    if (!m_grab.isMirrored) {
        m_region.forEach([&](Slot v) { orbit.grabbed.push_back({m_mesh.point(v), m_region.distance(v)}); });
        m_imageRegion.forEach([&](Slot v) {
            orbit.grabbedImage.push_back({m_mesh.point(v), m_imageRegion.distance(v)});
        });
        return;
    }
    m_mirror.setPlane(orbit.settings.symmetry);
    const Dab& dab = orbit.dabs[orbit.first];
    const bool isOver = m_mirror.folded(dab.position) != dab.position; // the half is the image's
    m_region.forEach([&](Slot v) {
        const Vec3f point = m_mesh.point(v), image = m_mirror.imageOf(point);
        orbit.grabbed.push_back({isOver ? image : point, m_region.distance(v)});
        if (!m_mirror.isOnPlane(v) && m_region.carried(v) <= dab.radius)
            orbit.grabbed.push_back({isOver ? point : image, m_region.carried(v)});
    });
    if (isOver)
        orbit.grab.axis = m_mirror.imageOf(orbit.grab.axis);
    m_mirror.setPlane(Symmetry::None);
}

void DabEngine::selectImages(Region& region, const std::vector<GrabbedPoint>& grabbed, const Turn& turn) const
{
    region.clear();
    for (const GrabbedPoint& place : grabbed) {
        if (const Slot v = vertexAt(m_surface, turn * place.point); v != noSlot)
            region.add(v, place.distance);
    }
}

/// For a tool that keeps its selection: swaps in that sector's grab, or swaps it back. The first sector's is in m_grab.
void DabEngine::swapSector(Tool tool, std::size_t sector)
{
    if (!keepsSelection(tool) || sector == 0)
        return;
    SectorGrab& other = m_sectors[sector];
    std::swap(m_grab, other.grab);
    std::swap(m_mirroredGrab, other.mirroredGrab);
    std::swap(m_region, other.region);
    std::swap(m_imageRegion, other.imageRegion);
    dropRemoved(m_grab, m_region);
    dropRemoved(m_mirroredGrab, m_imageRegion);
}

/// Of what went while others were at work; their slots may be other vertices' by now.
void DabEngine::dropRemoved(GrabState& grab, Region& region) const
{
    const std::vector<Slot>& removed = m_mesh.removedVertices();
    for (; grab.known < removed.size(); ++grab.known) {
        if (const Slot v = removed[grab.known]; region.contains(v))
            region.remove(v);
    }
}
} // namespace core
