// A dab in several sectors about the Y axis. Those that lie to each other by quarter or half turns are an orbit, whose first dab is done as
// always, and then
//   transplanted  to the others: its patch is exchanged there for the turned copy, bit for bit                          transplant
//   or repeated   where that cannot be: the surface is not its own image there, or the patches meet
// Orbits are done one after the other. What a tool that holds on has in its hands is kept for each sector by itself.

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
    bool adds = false; ///< solids
    Hold hold = {}, imageHold = {}; ///< before the first dab; so the next two
    std::vector<HeldPlace> held = {}, heldImage = {}; ///< `heldImage`: none, where a half stands for both
};

void DabEngine::runOnce(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between, DabReport& report)
{
    if (settings.symmetry == Symmetry::None)
        run(settings, dab, between, report);
    else
        runMirrored(settings, dab, between, report);
}

/// In a sector of its own hold.
DabReport DabEngine::runInSector(const Orbit& orbit, std::size_t sector)
{
    DabReport report;
    swapSector(orbit.settings.tool, sector);
    runOnce(orbit.settings, orbit.dabs[sector], orbit.between, report);
    swapSector(orbit.settings.tool, sector);
    return report;
}

void DabEngine::runRadial(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between, DabReport& report)
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
        report.apart = exact == dabs.size() && all.apart;
    }
}

/// A dab that finds nothing under its brush adds a solid: in all sectors, where the balls around them have room in all.
bool DabEngine::addsIn(const StrokeSettings& settings, const Dab& dab)
{
    if (!settings.add || !addsSolids(settings.tool))
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
    const bool isHeld = holdsOn(tool) && m_hold.isOn;
    if (isHeld)
        noteHeld(orbit);
    swapSector(tool, orbit.first);
    const Mesh::Mark mark = m_mesh.remember();
    DabReport report = runInSector(orbit, orbit.first);
    const DabReport once = report;
    const std::vector<std::size_t> others = othersIn(orbit);
    bool match = false;
    {
        const PhaseTimer timer(report.selectMs);
        m_transplant.learn(m_surface, mark, isHeld ? std::vector<Sphere>() : ballsOf(orbit));
        m_mesh.forget(mark);
        match = canTransplant(orbit, others);
    }
    report.apart = others.size() + 1 < orbit.dabs.size() / orbit.step; // the rest do the same, and yet are not exact images
    for (std::size_t i = 0; i < others.size(); ++i) {
        if (match && transplant(orbit, i, once, report))
            continue;
        match = match && !holdsOn(tool);
        holdApart(orbit, others[i]);
        report += runInSector(orbit, others[i]);
        report.apart = true;
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
bool DabEngine::canTransplant(const Orbit& orbit, const std::vector<std::size_t>& others)
{
    std::vector<Turn> turns;
    for (std::size_t sector : others) {
        if (m_sectors[sector].isApart)
            return false;
        turns.push_back(turnIn(orbit, sector));
    }
    return m_transplant.match(m_surface, turns);
}

/// What the orbit's first dab did, in one of those that canTransplant() found.
bool DabEngine::transplant(const Orbit& orbit, std::size_t other, const DabReport& once, DabReport& report)
{
    {
        const PhaseTimer timer(report.deformMs, m_surface.verifyMs());
        if (!m_transplant.place(m_surface, other))
            return false;
    }
    letGoOfRemoved(m_hold, m_region);
    letGoOfRemoved(m_imageHold, m_imageRegion);
    for (SectorHold& sector : m_sectors) {
        letGoOfRemoved(sector.hold, sector.region);
        letGoOfRemoved(sector.imageHold, sector.imageRegion);
    }
    if (orbit.settings.tool == Tool::Layer) {
        for (Slot v : m_transplant.vertices()) {
            if (const Slot image = m_transplant.imageOf(v); image != noSlot)
                noteRaised(image, raised(v));
        }
    }
    DabReport copy = once;
    copy.selectMs = copy.optimiseMs = copy.deformMs = copy.fuseMs = 0;
    report += copy;
    if (orbit.between && !m_transplant.isNothing())
        orbit.between();
    return true;
}

Turn DabEngine::turnIn(const Orbit& orbit, std::size_t sector)
{
    return Turn::part(static_cast<int>(sector - orbit.first), static_cast<int>(orbit.dabs.size()));
}

/// From now on this sector and those after it have what they hold in hands of their own: what the first held before its dab, turned. A dab
/// and its mirror image turn against each other.
void DabEngine::holdApart(const Orbit& orbit, std::size_t from)
{
    if (!holdsOn(orbit.settings.tool) || m_sectors[from].isApart)
        return;
    for (std::size_t sector = from; sector < orbit.dabs.size(); sector += orbit.step) {
        SectorHold& own = m_sectors[sector];
        if (std::exchange(own.isApart, true) || !orbit.hold.isOn)
            continue;
        const Turn turn = turnIn(orbit, sector), back = {turn.cosine, -turn.sine};
        const std::size_t known = m_mesh.removedVertices().size();
        if (orbit.hold.isMirrored) {
            holdHalf(orbit, own, turn);
            continue;
        }
        own.hold = {true, false, turn * orbit.hold.axis, orbit.hold.detail, known};
        own.imageHold = {orbit.imageHold.isOn, false, back * orbit.imageHold.axis, orbit.imageHold.detail, known};
        takeImages(own.region, orbit.held, turn);
        takeImages(own.imageRegion, orbit.heldImage, back);
    }
}

/// Where a half stood for both sides of the plane, it does so here. A quarter turn takes the plane elsewhere: what was held as a whole is
/// halved anew.
void DabEngine::holdHalf(const Orbit& orbit, SectorHold& own, const Turn& turn)
{
    m_mirror.setPlane(orbit.settings.symmetry);
    const Dab& dab = orbit.dabs[orbit.first];
    const Vec3 at = turn * dab.position, axis = turn * orbit.hold.axis;
    const bool isOver = m_mirror.folded(at) != at; // the half is the image's
    own.hold = {true, true, isOver ? m_mirror.imageOf(axis) : axis, orbit.hold.detail, m_mesh.removedVertices().size()};
    own.imageHold = {};
    own.imageRegion.clear();
    std::vector<HeldPlace> whole = orbit.held;
    for (HeldPlace& place : whole)
        place.point = isOver ? m_mirror.imageOf(turn * place.point) : turn * place.point;
    own.region.clear();
    for (const HeldPlace& place : whole) {
        if (const Slot v = vertexAt(m_surface, place.point); v != noSlot && m_mirror.isInHalf(v))
            own.region.add(v, place.distance, Vec3::Zero(), 2 * dab.radius);
    }
    for (const HeldPlace& place : whole) {
        if (const Slot v = vertexAt(m_surface, m_mirror.imageOf(place.point)); v != noSlot && own.region.contains(v))
            own.region.setCarried(v, place.distance);
    }
    m_mirror.setPlane(Symmetry::None);
}

/// Before the orbit's first dab, by place: its own, and its mirror image's where no half stands for both.
void DabEngine::noteHeld(Orbit& orbit)
{
    orbit.hold = m_hold;
    orbit.imageHold = m_imageHold;
    if (!m_hold.isMirrored) {
        m_region.forEach([&](Slot v) { orbit.held.push_back({m_mesh.point(v), m_region.distance(v)}); });
        m_imageRegion.forEach([&](Slot v) { orbit.heldImage.push_back({m_mesh.point(v), m_imageRegion.distance(v)}); });
        return;
    }
    m_mirror.setPlane(orbit.settings.symmetry);
    const Dab& dab = orbit.dabs[orbit.first];
    const bool isOver = m_mirror.folded(dab.position) != dab.position; // the half is the image's
    m_region.forEach([&](Slot v) {
        const Vec3f point = m_mesh.point(v), image = m_mirror.imageOf(point);
        orbit.held.push_back({isOver ? image : point, m_region.distance(v)});
        if (!m_mirror.isOnPlane(v) && m_region.carried(v) <= dab.radius)
            orbit.held.push_back({isOver ? point : image, m_region.carried(v)});
    });
    if (isOver)
        orbit.hold.axis = m_mirror.imageOf(orbit.hold.axis);
    m_mirror.setPlane(Symmetry::None);
}

void DabEngine::takeImages(Region& region, const std::vector<HeldPlace>& held, const Turn& turn) const
{
    region.clear();
    for (const HeldPlace& place : held) {
        if (const Slot v = vertexAt(m_surface, turn * place.point); v != noSlot)
            region.add(v, place.distance);
    }
}

/// Of a tool that holds on: takes into the hand what it holds in that sector, or puts it back. The first one's is in the hand.
void DabEngine::swapSector(Tool tool, std::size_t sector)
{
    if (!holdsOn(tool) || sector == 0)
        return;
    SectorHold& other = m_sectors[sector];
    std::swap(m_hold, other.hold);
    std::swap(m_imageHold, other.imageHold);
    std::swap(m_region, other.region);
    std::swap(m_imageRegion, other.imageRegion);
    letGoOfRemoved(m_hold, m_region);
    letGoOfRemoved(m_imageHold, m_imageRegion);
}

/// Of what went while others were at work; their slots may be other vertices' by now.
void DabEngine::letGoOfRemoved(Hold& hold, Region& region) const
{
    const std::vector<Slot>& removed = m_mesh.removedVertices();
    for (; hold.known < removed.size(); ++hold.known) {
        if (const Slot v = removed[hold.known]; region.contains(v))
            region.remove(v);
    }
}
} // namespace core
