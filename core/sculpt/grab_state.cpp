// What a stroke keeps from dab to dab: what a tool that keeps its selection has under its brush, and how far Layer has
// raised each vertex.

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
    m_grab = m_mirroredGrab = {};
    m_imageRegion.clear();
    m_sectors.clear();
    m_raisedVertices.clear();
    m_raised.clear();
}

/// The hand has not moved: nothing does.
DabReport DabEngine::rest(const StrokeSettings& settings, const Dab& dab)
{
    if (!m_grab.isOn)
        select(m_region, m_candidates, settings.brush, {dab.position, dab.radius});
    DabReport report;
    report.outcome = m_region.empty() ? DabOutcome::Empty : DabOutcome::Committed;
    report.touchedVertices = m_region.size();
    return report;
}

/// Selects the region, or keeps the grabbed one.
void DabEngine::take(const StrokeSettings& settings, const Sphere& ball)
{
    if (m_grab.isOn) {
        growSelection(settings, ball.radius);
        selectGrabbed();
        return;
    }
    select(m_region, m_candidates, settings.brush, ball);
    if (keepsSelection(settings.tool))
        m_grab = {false, false, meanNormal(m_region, m_mesh), detailPerMeanEdge * meanEdge(m_region)};
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

/// What is in the hand stays as fine as it was, until it meets something: fine meshes that are pressed together only
/// crumple.
EdgeBounds DabEngine::grabBounds(const StrokeSettings& settings, const EdgeBounds& bounds) const
{
    if (!keepsSelection(settings.tool) || settings.topology == Topology::Uniform || !(m_grab.detail > 0))
        return bounds;
    return edgeBounds(std::clamp(m_grab.detail, m_mesh.lattice().minDetail(), bounds.detail));
}

/// The same of the half, if the model is symmetric there. A half that was grabbed stays a half, symmetric or not.
bool DabEngine::takeMirrored(const StrokeSettings& settings, const Sphere& ball)
{
    const bool isGrabbed = m_grab.isOn;
    if (!isGrabbed)
        take(settings, ball);
    else if (m_grab.isMirrored)
        growSelection(settings, ball.radius);
    const bool mirrored = isGrabbed ? m_grab.isMirrored && selectGrabbed() : isMirroredIn(settings.brush, ball);
    if (mirrored) // some of the grabbed vertices may have been taken across the plane by another dab
        keepHalf(m_region, m_mirror);
    return mirrored;
}

/// What the hand has drawn away from joins with no weight: an edge that has one end alone in the region is not split,
/// however long it grows, and long ones are soon in the way.
void DabEngine::growSelection(const StrokeSettings& settings, double radius)
{
    if (settings.falloff == 0) // all that is in the region weighs
        return;
    const EdgeBounds bounds = boundsFor(settings, radius);
    const double detail = m_grab.limits.inUse() ? bounds.detail : grabBounds(settings, bounds).detail;
    std::vector<Slot> rim;
    m_region.forEach([&](Slot v) {
        if (m_region.distance(v) >= radius && !(m_grab.isMirrored && m_region.carried(v) < radius))
            return; // has joined like that
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot other = m_mesh.to(h);
            if (!m_region.contains(other) &&
                (m_mesh.point(other) - m_mesh.point(v)).cast<double>().squaredNorm() > detail * detail)
                rim.push_back(other);
        });
    });
    for (Slot v : rim)
        m_region.add(v, radius, Vec3::Zero(), 2 * radius);
}

/// Takes the faces around the grabbed region as candidates. Returns whether they have mirror images.
bool DabEngine::selectGrabbed()
{
    SlotSet& faces = m_region.scratch();
    faces.clear();
    m_region.forEach([&](Slot v) { m_mesh.forEachOutgoing(v, [&](Slot h) { faces.add(m_mesh.face(h)); }); });
    faces.sort();
    m_candidates = faces.slots();
    return m_mirror.isOn() && m_mirror.learn(m_candidates, m_surface.octree());
}

/// What stood in the way of what is in the hand still does while that goes on in the same way: it is not found out anew
/// in each dab.
void DabEngine::recallLimits(Task& task)
{
    const Vec3 way = wayOf(task.dab);
    if (!m_grab.limits.inUse() || way.dot(m_grab.way) < sameWay * way.norm() * m_grab.way.norm())
        return;
    m_limits = std::move(m_grab.limits);
    task.fallbackSubsteps = m_grab.fallbackSubsteps;
    allowFusion(task);
}

void DabEngine::noteLimits(const Task& task, const DabReport& report)
{
    if (!m_limits.inUse() || !report.isWhole()) // else the limits are too tight
        return;
    m_grab.way = wayOf(task.dab);
    m_grab.limits = std::move(m_limits);
    m_grab.fallbackSubsteps = task.fallbackSubsteps;
}

/// For a tool that keeps its selection: swaps in the state of the mirrored dab. Drops vertices that were removed
/// meanwhile.
void DabEngine::swapGrabs(Tool tool)
{
    if (!keepsSelection(tool))
        return;
    std::swap(m_grab, m_mirroredGrab);
    std::swap(m_region, m_imageRegion);
    dropRemoved(m_grab, m_region);
}

/// All that the dab moves.
Sphere DabEngine::ballAround(const Dab& dab) const
{
    if (!m_grab.isOn)
        return {dab.position, dab.radius};
    Box box;
    m_region.forEach([&](Slot v) { box.extend(m_mesh.point(v).cast<double>()); });
    return {box.center(), 0.5 * box.diagonal().norm()};
}

/// What the dab alone selects, of both halves. Precondition: mirrored; the region is of the half.
void DabEngine::selectBothSides(const Task& task)
{
    const bool isRay = task.settings.brush == BrushShape::Ray;
    if (m_grab.isOn)
        selectWholeGrabbed(m_whole, m_region, m_mirror, task.dab.radius);
    else if (isRay)
        selectRefined(m_whole, task.ball);
    else
        selectWhole(m_whole, m_region, m_mirror, m_mesh, task.ball);
    if (m_grab.isOn || (!keepsSelection(task.settings.tool) && task.settings.tool != Tool::Layer))
        return;
    m_region.forEach([&](Slot v) {
        const Slot image = m_mirror.imageOf(v);
        if (task.settings.tool != Tool::Layer)
            m_region.setCarried(v, image != noSlot && m_whole.contains(image) ? m_whole.distance(image)
                                                                              : 2 * task.dab.radius);
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
