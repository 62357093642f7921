// Topology fusion (paper, section 3.4):
//   find       finds pairs of vertices that the motion is about to bring into contact        (fusion_candidates)
//   join       nearest pairs first: removes both stars and connects the 1-rings              (ring_join, mirrored_join)
//   operate    verifies each join by itself                                                  (fusion_surgery)
//   separate   cuts necks and removes specks where an edge can no longer be collapsed        (separation)
//   merge      merges joins that have a short tunnel or a thin strand between them           (cycle_search, cycle_cut)

#include "core/sculpt/fuse/fusion.h"

#include "core/sculpt/fuse/cycle_cut.h"
#include "core/sculpt/fuse/mirrored_join.h"
#include "core/sculpt/fuse/ring_join.h"

#include <algorithm>

namespace core
{
namespace
{
/// A stroke starts no tunnel nearer than minTunnelDistance (d_detail) to an earlier one: the earlier one is widened
/// instead. Cutting a neck ends the tunnels nearer to it than endedTunnelDistance (d_detail).
constexpr double minTunnelDistance = 4, endedTunnelDistance = 1;
/// Largest lengths, in d_detail, of the cycle around a tunnel that is filled and around a strand that is cut between
/// two joins. cycleGaps: gaps to try between the two sides of a cut, in d.
constexpr double maxTunnelLength = 6, maxStrandLength = 6;
constexpr double cycleGaps[] = {0.5, 0.1};
/// Largest number of rounds of joining in a sub-step. A guard only: normally a round that joins nothing ends the loop.
constexpr int maxRounds = 64;

/// Returns the vertices that still exist, and the created ones.
std::vector<Slot> cornersLeft(const Mesh& mesh, std::vector<Slot> vertices, const std::vector<Slot>& created)
{
    std::erase_if(vertices, [&](Slot v) { return !mesh.isVertex(v); });
    vertices.insert(vertices.end(), created.begin(), created.end());
    return vertices;
}
} // namespace

void TopologyFusion::beginStroke()
{
    m_tunnels.clear();
    m_joints.clear();
}

void TopologyFusion::beginDab(MirrorMap* mirror, double detailShare, double shredSize)
{
    m_surgery.beginDab(mirror);
    m_candidates.setMirror(mirror);
    m_separation.beginDab(detailShare, shredSize);
    m_joined.clear();
    m_pierced.clear();
}

bool TopologyFusion::predictContact(const VerifiedMesh& surface, const Region& region, const EdgeBounds& bounds)
{
    m_candidates.find(surface, region, {}, {true, bounds, 1});
    return !m_candidates.pairs().empty();
}

/// Joins in rounds, in each of which at most one tunnel starts. A tunnel is first widened over the whole contact;
/// starting two side by side would leave a hole between them.
std::uint64_t TopologyFusion::join(VerifiedMesh& surface, Region& region, MotionLimits& limits,
                                   const FusionInput& input)
{
    std::uint64_t joins = 0;
    for (int round = 0; round < maxRounds; ++round) {
        if (limits.inUse())
            limits.extend(region, surface.mesh()); // the previous round may have added copies of vertices to the region
        m_candidates.find(surface, region, limits, input);
        m_candidates.dropTunnelsBesideJoins(surface.mesh());
        m_candidates.sort();
        const std::uint64_t joined = joinPairs(surface, region, input);
        if (joined == 0)
            break;
        joins += joined;
        if (static_cast<double>(m_candidates.visits()) >= input.maxVisits)
            break;
    }
    return joins;
}

std::uint64_t TopologyFusion::joinPairs(VerifiedMesh& surface, Region& region, const FusionInput& input)
{
    const Mesh& mesh = surface.mesh();
    std::uint64_t joined = 0;
    m_done.clear();
    for (const FusionPair& pair : m_candidates.pairs()) {
        if (pair.startsTunnel && joined > 0)
            break;
        if (!mayJoin(mesh, pair))
            continue;
        const Vec3 middle = 0.5 * (mesh.point(pair.p).cast<double>() + mesh.point(pair.q).cast<double>());
        const double beside = minTunnelDistance * input.bounds.detail;
        const auto isBeside = [&](const Vec3& tunnel) { return (tunnel - middle).norm() < beside; };
        if (pair.startsTunnel && std::ranges::any_of(m_tunnels, isBeside))
            continue;
        if (!joinPair(surface, region, pair, input.bounds))
            continue;
        ++joined;
        if (pair.startsTunnel)
            m_tunnels.push_back(middle);
    }
    if (input.rest && joined > 0)
        forgetDetail(mesh, *input.rest, input.bounds.thickness());
    return joined;
}

/// Discards the rest lengths around the joins, so that the mesh there becomes as coarse as the brush makes it.
/// Otherwise the next sub-steps, whose length suits the brush, would leave gaps between the joins of a finer mesh.
/// `reach`: distance from the joins along the edges, mm.
void TopologyFusion::forgetDetail(const Mesh& mesh, RestLengths& rest, double reach) const
{
    SlotSet seen;
    std::vector<double> left; // part of `reach` that remains at each vertex, mm, by position in `seen`
    const auto visit = [&](Slot v, double reachThere) {
        if (reachThere < 0 || !seen.add(v))
            return;
        left.push_back(reachThere);
        rest.noteNew(v);
    };
    for (Slot v : m_done.slots()) {
        if (mesh.isVertex(v))
            visit(v, reach);
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Slot v = seen.slots()[i];
        mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot other = mesh.to(h);
            visit(other, left[i] - (mesh.point(other) - mesh.point(v)).cast<double>().norm());
        });
    }
}

bool TopologyFusion::mayJoin(const Mesh& mesh, const FusionPair& pair) const
{
    const auto mayGo = [&](Slot v) { return !mesh.isMasked(v) && !m_done.contains(v) && m_surgery.mayTry(v); };
    const bool isThere = mesh.isVertex(pair.p) && mesh.isVertex(pair.q); // a vertex may have been removed with a speck
    return isThere && mayGo(pair.p) && mayGo(pair.q);
}

/// Joins the pair with Stepping::Even or, if that fails, with Stepping::Nearest. The vertices around the join take part
/// in no other join of this round.
bool TopologyFusion::joinPair(VerifiedMesh& surface, Region& region, const FusionPair& pair, const EdgeBounds& bounds)
{
    const Mesh& mesh = surface.mesh();
    bool hasFailed = false;
    for (Stepping stepping : {Stepping::Even, Stepping::Nearest}) {
        const std::optional<Surgery> surgery = joining(surface, pair, stepping);
        if (!surgery)
            continue;
        const std::vector<Slot> around = cornersOf(mesh, surgery->removed);
        const std::optional<std::vector<Slot>> created = m_surgery.operate(surface, region, *surgery);
        if (!created) {
            hasFailed = true;
            continue;
        }
        if (!created->empty()) // a vertex with several umbrellas was split; one part may be a speck
            m_separation.removeSpecks(surface, region, cornersLeft(mesh, around, *created), bounds);
        for (const std::vector<Slot>* vertices : {&around, &*created}) {
            for (Slot v : *vertices) {
                m_done.add(v);
                m_joined.add(v);
                m_joints.add(v);
                if (pair.inside)
                    m_pierced.add(v);
            }
        }
        return true;
    }
    if (hasFailed) {
        m_surgery.countFailure(pair.p);
        m_surgery.countFailure(pair.q);
    }
    return false;
}

std::optional<Surgery> TopologyFusion::joining(const VerifiedMesh& surface, const FusionPair& pair,
                                               Stepping stepping) const
{
    const Mesh& mesh = surface.mesh();
    const MirrorMap* mirror = m_surgery.mirror();
    if (!mirror)
        return joinStars(mesh, pair.p, pair.q, stepping);
    const bool pOnPlane = mirror->isOnPlane(pair.p), qOnPlane = mirror->isOnPlane(pair.q);
    std::optional<Surgery> half;
    if (!mirror->isInHalf(pair.p) || !mirror->isInHalf(pair.q))
        half = joinAcross(mesh, *mirror, mirror->isInHalf(pair.p) ? pair.p : pair.q);
    else if (pOnPlane && qOnPlane)
        half = joinOnPlane(mesh, *mirror, pair.p, pair.q);
    else if (pOnPlane || qOnPlane)
        // with the image there would be three stars; a neighbouring vertex on the plane is near too and can join
        return std::nullopt;
    else
        half = joinStars(mesh, pair.p, pair.q, stepping);
    return m_surgery.withItsImage(surface, half);
}

/// Forgets the tunnels at which necks were cut: the surfaces there may join again.
void TopologyFusion::forgetTunnelsAtNecks(double detail)
{
    const double near = endedTunnelDistance * detail;
    for (const Vec3& neck : m_separation.takeNecks())
        std::erase_if(m_tunnels, [&](const Vec3& tunnel) { return (tunnel - neck).norm() < near; });
}

std::uint64_t TopologyFusion::separate(VerifiedMesh& surface, Region& region, const std::vector<VertexPair>& blocked,
                                       const EdgeBounds& bounds)
{
    const std::uint64_t separations = m_separation.separate(surface, region, blocked, bounds);
    forgetTunnelsAtNecks(bounds.detail);
    return separations;
}

void TopologyFusion::addJoined(Region& region, const Mesh& mesh, const Vec3& center) const
{
    const MirrorMap* mirror = m_surgery.mirror();
    for (Slot v : m_joined.slots()) {
        if (mesh.isVertex(v) && !region.contains(v) && (!mirror || mirror->isInHalf(v)))
            region.add(v, (mesh.point(v).cast<double>() - center).norm());
    }
}

/// Returns the live vertices of the set, and their neighbours. `region`: if not null, only vertices in the region are
/// used.
SlotSet TopologyFusion::neighboursOf(const SlotSet& vertices, const Mesh& mesh, const Region* region)
{
    SlotSet around;
    for (Slot v : vertices.slots()) {
        if (!mesh.isVertex(v) || (region && !region->contains(v)))
            continue;
        around.add(v);
        mesh.forEachOutgoing(v, [&](Slot h) { around.add(mesh.to(h)); });
    }
    return around;
}

std::uint64_t TopologyFusion::cutCycles(VerifiedMesh& surface, Region& region, const EdgeBounds& bounds,
                                        const RestLengths* rest)
{
    const std::uint64_t merged = mergeJoins(surface, region, bounds);
    const SlotSet around = neighboursOf(m_joints, surface.mesh(), &region);
    const std::uint64_t cuts = m_separation.cutCycles(surface, region, around.slots(), bounds, rest);
    forgetTunnelsAtNecks(bounds.detail);
    return merged + cuts;
}

std::uint64_t TopologyFusion::mergeJoins(VerifiedMesh& surface, Region& region, const EdgeBounds& bounds)
{
    const Mesh& mesh = surface.mesh();
    const MirrorMap* mirror = m_surgery.mirror();
    std::uint64_t merged = 0;
    const SlotSet around = neighboursOf(m_joined, mesh, nullptr);
    for (Slot v : around.slots()) {
        if (mesh.isVertex(v) && (!mirror || mirror->isInHalf(v)) && m_surgery.mayTry(v))
            merged += mergeJoinsAt(surface, region, v, around, bounds);
    }
    return merged;
}

/// Fills a tunnel between two joins near the vertex. Cuts a strand between two joins instead if the vertex is at a hole
/// pushed through a wall, or if the tunnel cannot be filled, for example because something passes through it. `around`:
/// the vertices at this dab's joins. Only cycles of these are considered, because other cycles run around holes and
/// handles of the model.
bool TopologyFusion::mergeJoinsAt(VerifiedMesh& surface, Region& region, Slot v, const SlotSet& around,
                                  const EdgeBounds& bounds)
{
    using enum CycleSearch::Around;
    const Mesh& mesh = surface.mesh();
    const auto find = [&](CycleSearch::Around kind, double length) {
        return m_cycleSearch.find(mesh, around, v, kind, length * bounds.detail);
    };
    if (!m_pierced.contains(v)) {
        const std::vector<Slot> tunnel = find(Tunnel, maxTunnelLength);
        const bool isHole = std::ranges::any_of(tunnel, [&](Slot w) { return m_pierced.contains(w); });
        if (tunnel.empty() || isHole)
            return false;
        if (cut(surface, region, tunnel, bounds))
            return true;
    }
    const std::vector<Slot> strand = find(Handle, maxStrandLength);
    if (!strand.empty() && cut(surface, region, strand, bounds))
        return true;
    m_surgery.countFailure(v);
    return false;
}

/// Cuts the surface along the cycle and caps both sides. Adds the new vertices to m_joined and m_joints.
bool TopologyFusion::cut(VerifiedMesh& surface, Region& region, const std::vector<Slot>& cycle,
                         const EdgeBounds& bounds)
{
    for (const double gap : cycleGaps) {
        const std::optional<Surgery> surgery = m_surgery.withItsImage(
            surface, cutCycle(surface.mesh(), cycle, DrawBack::AlongSurface, gap * bounds.minimum));
        if (!surgery)
            return false;
        if (const auto created = m_surgery.operate(surface, region, *surgery)) {
            for (Slot v : *created) {
                m_joined.add(v);
                m_joints.add(v);
            }
            return true;
        }
    }
    return false;
}

bool TopologyFusion::isContact(const VerifiedMesh& surface, const Region& region, const FusionInput& input, bool fusion,
                               const std::vector<Slot>& vertices)
{
    const Mesh& mesh = surface.mesh();
    MirrorMap* mirror = m_surgery.mirror();
    SlotSet& at = m_done;
    at.clear();
    for (Slot v : vertices) { // vertices created by a change that was rolled back no longer exist
        if (v >= mesh.slots().vertices || !mesh.isVertex(v))
            continue;
        if (const Slot named = mirror && !mirror->isInHalf(v) ? mirror->imageOf(v) : v; named != noSlot)
            at.add(named);
    }
    FusionInput pushing = input;
    pushing.pushes = true; // also finds pairs on the two sides of a wall
    m_candidates.find(surface, region, {}, pushing);
    return std::ranges::any_of(m_candidates.pairs(), [&](const FusionPair& pair) {
        const bool mayFuse =
            fusion && (input.pushes || !pair.inside) && !mesh.isMasked(pair.p) && !mesh.isMasked(pair.q);
        return !mayFuse && (at.contains(pair.p) || at.contains(pair.q));
    });
}
} // namespace core
