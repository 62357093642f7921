// What a stroke keeps from dab to dab: what a tool that holds on has under its brush, and how far Layer has raised each vertex.

#include "core/sculpt/dab_engine.h"

#include "core/sculpt/deform/deform.h"
#include "core/sculpt/deform/mirrored_deform.h"

namespace core
{
namespace
{
/// The cosine of the angle that ways of dabs may differ by and be the same.
constexpr double sameWay = 0.9;

Vec3 wayOf(const Dab& dab)
{
    return dab.turn != 0 ? Vec3(dab.turn * dab.axis) : dab.motion;
}
} // namespace

void DabEngine::beginStroke()
{
    m_hold = m_imageHold = {};
    m_imageRegion.clear();
    m_sectors.clear();
    m_raisedVertices.clear();
    m_raised.clear();
}

/// The hand has not moved: nothing does.
DabReport DabEngine::rest(const StrokeSettings& settings, const Dab& dab)
{
    if (!m_hold.isOn)
        select(m_region, m_candidates, settings.brush, {dab.position, dab.radius});
    DabReport report;
    report.outcome = m_region.empty() ? DabOutcome::Empty : DabOutcome::Committed;
    report.touchedVertices = m_region.size();
    return report;
}

/// The region is selected, or held.
void DabEngine::take(const StrokeSettings& settings, const Sphere& ball)
{
    if (m_hold.isOn) {
        joinRim(settings, ball.radius);
        takeHeld();
        return;
    }
    select(m_region, m_candidates, settings.brush, ball);
    if (holdsOn(settings.tool))
        m_hold = {false, false, meanNormal(m_region, m_mesh), detailPerMeanEdge * meanEdge(m_region)};
}

/// Of the edges within the region; 0 if it has none.
double DabEngine::meanEdge(const Region& region) const
{
    double sum = 0;
    int n = 0;
    region.forEach([&](Slot v) {
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            if (const Slot other = m_mesh.to(h); other > v && region.contains(other)) {
                sum += (m_mesh.point(other) - m_mesh.point(v)).cast<double>().norm();
                ++n;
            }
        });
    });
    return n > 0 ? sum / n : 0;
}

/// What is in the hand stays as fine as it was, until it meets something: fine meshes that are pressed together only crumple.
EdgeBounds DabEngine::boundsInHand(const StrokeSettings& settings, const EdgeBounds& bounds) const
{
    if (!holdsOn(settings.tool) || settings.topology == Topology::Uniform || !(m_hold.detail > 0))
        return bounds;
    return edgeBounds(std::clamp(m_hold.detail, m_mesh.lattice().minDetail(), bounds.detail));
}

/// The same of the half, if the model is symmetric there. What was held as a half and is symmetric no more stays one.
bool DabEngine::takeMirrored(const StrokeSettings& settings, const Sphere& ball)
{
    const bool isHeld = m_hold.isOn;
    if (!isHeld)
        take(settings, ball);
    else if (m_hold.isMirrored)
        joinRim(settings, ball.radius);
    const bool mirrored = isHeld ? m_hold.isMirrored && takeHeld() : isMirroredIn(settings.brush, ball);
    if (mirrored) // of what is held some may have been taken across the plane by another dab
        keepHalf(m_region, m_mirror);
    return mirrored;
}

/// What the hand has drawn away from joins with no weight: an edge that has one end alone in the region is not split, however long it grows,
/// and long ones are soon in the way.
void DabEngine::joinRim(const StrokeSettings& settings, double radius)
{
    if (settings.falloff == 0) // all that is in the region weighs
        return;
    const EdgeBounds bounds = boundsFor(settings, radius);
    const double detail = m_hold.held.inUse() ? bounds.detail : boundsInHand(settings, bounds).detail;
    std::vector<Slot> rim;
    m_region.forEach([&](Slot v) {
        if (m_region.distance(v) >= radius && !(m_hold.isMirrored && m_region.carried(v) < radius))
            return; // has joined like that
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot other = m_mesh.to(h);
            if (!m_region.contains(other) && (m_mesh.point(other) - m_mesh.point(v)).cast<double>().squaredNorm() > detail * detail)
                rim.push_back(other);
        });
    });
    for (Slot v : rim)
        m_region.add(v, radius, Vec3::Zero(), 2 * radius);
}

/// The faces around what is held; whether they have images.
bool DabEngine::takeHeld()
{
    SlotSet& faces = m_region.scratch();
    faces.clear();
    m_region.forEach([&](Slot v) { m_mesh.forEachOutgoing(v, [&](Slot h) { faces.add(m_mesh.face(h)); }); });
    faces.sort();
    m_candidates = faces.slots();
    return m_mirror.isOn() && m_mirror.learn(m_candidates, m_surface.octree());
}

/// What stood in the way of what is in the hand still does while that goes on in the same way: it is not found out anew in each dab.
void DabEngine::recallHeldBack(Task& task)
{
    const Vec3 way = wayOf(task.dab);
    if (!m_hold.held.inUse() || way.dot(m_hold.way) < sameWay * way.norm() * m_hold.way.norm())
        return;
    m_held = std::move(m_hold.held);
    task.carefulSubsteps = m_hold.carefulSubsteps;
    meet(task);
}

void DabEngine::noteHeldBack(const Task& task, const DabReport& report)
{
    if (!m_held.inUse() || !report.isWhole()) // else it has held back too much
        return;
    m_hold.way = wayOf(task.dab);
    m_hold.held = std::move(m_held);
    m_hold.carefulSubsteps = task.carefulSubsteps;
}

/// Of a tool that holds on. What was removed meanwhile, with the other hold, is let go.
void DabEngine::swapHolds(Tool tool)
{
    if (!holdsOn(tool))
        return;
    std::swap(m_hold, m_imageHold);
    std::swap(m_region, m_imageRegion);
    letGoOfRemoved(m_hold, m_region);
}

/// All that the dab moves.
Sphere DabEngine::ballAround(const Dab& dab) const
{
    if (!m_hold.isOn)
        return {dab.position, dab.radius};
    Box box;
    m_region.forEach([&](Slot v) { box.extend(m_mesh.point(v).cast<double>()); });
    return {box.center(), 0.5 * box.diagonal().norm()};
}

/// What the dab alone selects, of both halves. Precondition: mirrored; the region is of the half.
void DabEngine::selectBothSides(const Task& task)
{
    const bool isRay = task.settings.brush == BrushShape::Ray;
    if (m_hold.isOn)
        selectWholeHeld(m_whole, m_region, m_mirror, task.dab.radius);
    else if (isRay)
        selectRefined(m_whole, task.ball);
    else
        selectWhole(m_whole, m_region, m_mirror, m_mesh, task.ball);
    if (m_hold.isOn || (!holdsOn(task.settings.tool) && task.settings.tool != Tool::Layer))
        return;
    m_region.forEach([&](Slot v) {
        const Slot image = m_mirror.imageOf(v);
        if (task.settings.tool != Tool::Layer)
            m_region.setCarried(v, image != noSlot && m_whole.contains(image) ? m_whole.distance(image) : 2 * task.dab.radius);
        for (Slot side : {v, image}) {
            if (side != noSlot && m_whole.contains(side))
                m_whole.setCarried(side, m_region.carried(v));
        }
    });
}

/// Negative: not known.
double DabEngine::raised(Slot v) const
{
    const Slot i = m_raisedVertices.find(v);
    return i == noSlot ? -1 : m_raised[i];
}

/// The mean of the neighbours that are known, or 0.
double DabEngine::raisedAround(Slot v) const
{
    double sum = 0;
    int known = 0;
    m_mesh.forEachOutgoing(v, [&](Slot h) {
        const double beside = raised(m_mesh.to(h));
        sum += std::max(beside, 0.0);
        known += beside < 0 ? 0 : 1;
    });
    return known > 0 ? sum / known : 0;
}

/// What has come since the dab before is as high as its neighbours are.
void DabEngine::recallRaised()
{
    m_region.forEach([&](Slot v) { m_region.setCarried(v, raised(v) < 0 ? raisedAround(v) : raised(v)); });
}

/// `share`: of the plan, that was reached.
void DabEngine::noteRaised(double share)
{
    for (Slot v : m_region.slots()) {
        const bool isThere = m_region.contains(v);
        const double raised = isThere ? m_region.carried(v) + share * m_region.plan(v).norm() : -1;
        noteRaised(v, raised);
        if (const Slot image = m_mirror.isOn() && isThere ? m_mirror.imageOf(v) : noSlot; image != noSlot)
            noteRaised(image, raised);
    }
}

void DabEngine::noteRaised(Slot v, double raised)
{
    const Slot i = m_raisedVertices.add(v);
    m_raised.resize(m_raisedVertices.size());
    m_raised[i] = raised;
}
} // namespace core
