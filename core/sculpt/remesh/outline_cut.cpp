#include "core/sculpt/remesh/outline_cut.h"

#include <algorithm>
#include <tuple>

namespace core
{
namespace
{
/// The end of an edge is moved onto the outline, instead of splitting the edge, if it is nearer to the crossing than
/// this share of the edge's length.
constexpr double nearShare = 0.35;
/// Limits for moving a vertex onto the outline. Angles may shrink to 15 degrees; a smaller angle must keep half of its
/// sine. An edge longer than d_detail may grow by the factor sqrt(2). These limits are loose, because a vertex left
/// beside the outline would make far shorter edges.
constexpr FaceLimits movedLimits = {0.259, 0, 0.25, 2};
/// Distance from the outline to the foot of a wall, in d_detail.
constexpr double footShare = 0.12;
/// Bisection steps to locate the outline on an edge.
constexpr int halvings = 30;
} // namespace

OutlineCut::OutlineCut(RemeshPass& pass, const ShapeDepth& depth, const Sphere& ball)
    : m_pass(pass)
    , m_mesh(pass.mesh())
    , m_depth(depth)
    , m_ball(ball)
{}

SlotSet OutlineCut::cut()
{
    SlotSet own;
    cut(m_depth, own);
    MirrorMap* mirror = m_pass.edit().mirror();
    if (!mirror)
        return own;
    SlotSet image;
    cut([&](const Vec3& p) { return m_depth(mirror->imageOf(p)); }, image);
    for (Slot v : image.slots())
        own.add(mirror->imageOf(v));
    return own;
}

void OutlineCut::cut(const ShapeDepth& depth, SlotSet& outline)
{
    moveNearest(crossings(depth, outline), outline);
    splitCrossing(crossings(depth, outline), outline);
    splitInwards(depth, outline);
}

/// Returns the edges at the region's vertices that cross the outline, sorted by their ends.
std::vector<OutlineCut::Crossing> OutlineCut::crossings(const ShapeDepth& depth, const SlotSet& outline)
{
    std::vector<Crossing> crossings;
    m_pass.region().forEach([&](Slot v) {
        const Vec3 p = m_pass.point(v);
        if (outline.contains(v) || depth(p) == 0)
            return;
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot u = m_mesh.to(h);
            const MirrorMap* mirror = m_pass.edit().mirror();
            if (outline.contains(u) || (mirror && !mirror->isInHalf(u)) || depth(m_pass.point(u)) != 0)
                return;
            const Vec3 way = m_pass.point(u) - p;
            double in = 0, out = 1;
            for (int i = 0; i < halvings; ++i) {
                const double middle = 0.5 * (in + out);
                (depth(p + middle * way) != 0 ? in : out) = middle;
            }
            crossings.push_back({v, u, p + out * way, std::min(out, 1 - out), out < 0.5});
        });
    });
    std::ranges::sort(crossings, {}, [](const Crossing& c) { return std::tie(c.inside, c.outside); });
    return crossings;
}

/// Moves ends of edges that are close to the outline onto it, the nearest first, each vertex at most once.
void OutlineCut::moveNearest(std::vector<Crossing> crossings, SlotSet& outline)
{
    std::erase_if(crossings, [](const Crossing& c) { return c.share > nearShare; });
    std::ranges::stable_sort(crossings, {}, &Crossing::share);
    for (const Crossing& crossing : crossings) {
        const Slot v = crossing.nearer();
        if (m_cut.contains(v) || outline.contains(crossing.inside) || outline.contains(crossing.outside) ||
            !move(crossing))
            continue;
        m_cut.add(v);
        outline.add(v);
        addToRegion(crossing.inside);
        addToRegion(crossing.outside);
    }
}

/// Moves the nearer end of an edge onto the outline. Refuses moves that would leave a face with all corners on the
/// outline, as such a face would be neither inside nor outside.
bool OutlineCut::move(const Crossing& crossing)
{
    const Slot v = crossing.nearer();
    bool wouldClose = false;
    m_mesh.forEachOutgoing(v, [&](Slot h) {
        wouldClose = wouldClose || (m_cut.contains(m_mesh.to(h)) && m_cut.contains(m_mesh.to(m_mesh.next(h))));
    });
    if (wouldClose)
        return false;
    const Vec3f target = m_mesh.lattice().snap(crossing.point);
    return m_pass.edit().kept(v, target) == target && !isSharp(m_mesh, v) &&
           m_pass.staysSound(v, noSlot, target.cast<double>(), movedLimits) && m_pass.edit().move(v, target);
}

/// Splits the edges at their intersections with the outline.
void OutlineCut::splitCrossing(const std::vector<Crossing>& crossings, SlotSet& outline)
{
    for (const Crossing& crossing : crossings) {
        const Slot m = split(crossing.inside, crossing.outside, crossing.point);
        if (m == noSlot)
            continue;
        m_cut.add(m);
        outline.add(m);
        addToRegion(crossing.inside);
        addToRegion(crossing.outside);
    }
}

/// Splits the edges that lead inwards from the outline, close to the outline, where the shape is deeper than d.
void OutlineCut::splitInwards(const ShapeDepth& depth, const SlotSet& outline)
{
    const double foot = footShare * std::sqrt(m_pass.detail2());
    std::vector<std::pair<VertexPair, Vec3>> splits;
    for (Slot v : outline.slots()) {
        const Vec3 p = m_pass.point(v);
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot u = m_mesh.to(h);
            if (m_cut.contains(u) || !m_pass.region().contains(u) || depth(m_pass.point(u)) == 0)
                return;
            const Vec3 way = m_pass.point(u) - p, place = p + foot / way.norm() * way;
            const double deep = depth(place);
            if (way.squaredNorm() > 4 * foot * foot && deep * deep > m_pass.minimum2())
                splits.push_back({{v, u}, place});
        });
    }
    for (const auto& [edge, place] : splits)
        split(edge[0], edge[1], place);
}

/// Splits an edge at a point. Returns the new vertex, or noSlot if the split was refused.
Slot OutlineCut::split(Slot from, Slot to, const Vec3& point)
{
    const Slot h = m_mesh.findHalfedge(from, to);
    if (h == noSlot || !m_mesh.mayBeSplit(h / 2) || !m_pass.mayGoOn())
        return noSlot;
    const Slot m = m_pass.edit().split(h / 2, m_mesh.lattice().snap(point));
    if (m == noSlot)
        return noSlot;
    ++m_pass.counts.splits;
    m_pass.noteNew(m);
    addToRegion(m);
    return m;
}

void OutlineCut::addToRegion(Slot v)
{
    if (!m_pass.region().contains(v))
        m_pass.region().add(v, (m_pass.point(v) - m_ball.center).norm());
}
} // namespace core
