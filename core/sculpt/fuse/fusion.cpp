// Topology fusion (paper, section 3.4):
//   join       vertices that the motion is about to bring into contact lose their stars, the 1-rings are connected
//     near       pairs that are about to meet fusion_candidates.cpp operate    nearest first, each verified by itself
//   separate   what can no longer be collapsed, in separation.cpp

#include "core/sculpt/fuse/fusion.h"

#include "core/sculpt/fuse/mirrored_join.h"
#include "core/sculpt/fuse/ring_join.h"

#include <algorithm>
#include <tuple>

namespace core
{
namespace
{
/// No dab begins two tubes nearer to each other than this, in terms of d_detail: the first one's seam is to get there.
constexpr double tubeDistance = 4;
/// Rounds of joining in a sub-step: a guard, the last ones join nothing.
constexpr int maxRounds = 64;

std::vector<Slot> cornersOf(const Mesh& mesh, const std::vector<Slot>& faces)
{
    std::vector<Slot> corners;
    for (Slot f : faces)
        corners.insert(corners.end(), mesh.corners(f).begin(), mesh.corners(f).end());
    return corners;
}

/// Those of the vertices that are still there, and the new ones.
std::vector<Slot> cornersLeft(const Mesh& mesh, std::vector<Slot> vertices, const std::vector<Slot>& created)
{
    std::erase_if(vertices, [&](Slot v) { return !mesh.isVertex(v); });
    vertices.insert(vertices.end(), created.begin(), created.end());
    return vertices;
}
} // namespace

/// In rounds: a seam grows stitch by stitch over all of a contact before another tube is begun, else a hole stays
/// between.
FusionCounts TopologyFusion::join(VerifiedMesh& surface, Region& region, MotionLimits& limits, const FusionInput& input)
{
    FusionCounts counts;
    for (int round = 0; round < maxRounds; ++round) {
        if (limits.inUse())
            limits.extend(region, surface.mesh()); // copies joined the region in the round before
        gather(surface, region, input.reach());
        findNear(surface.mesh(), region, limits, input);
        if (m_mirror)
            keepToSeams(surface.mesh());
        const std::uint64_t joined = joinNear(surface, region, input.bounds);
        if (joined == 0)
            break;
        counts.fusions += joined;
    }
    return counts;
}

std::uint64_t TopologyFusion::joinNear(VerifiedMesh& surface, Region& region, const EdgeBounds& bounds)
{
    std::ranges::sort(m_near, [](const Near& a, const Near& b) {
        return std::tie(a.isolated, a.distance2, a.p, a.q) < std::tie(b.isolated, b.distance2, b.p, b.q);
    });
    const Mesh& mesh = surface.mesh();
    std::uint64_t joined = 0;
    m_done.clear();
    for (const Near& near : m_near) {
        if (near.isolated && joined > 0)
            break;
        const bool isThere = mesh.isVertex(near.p) && mesh.isVertex(near.q); // they may have gone with a speck
        if (!isThere || mesh.isMasked(near.p) || mesh.isMasked(near.q) || m_done.contains(near.p) ||
            m_done.contains(near.q) || !mayTry(near.p) || !mayTry(near.q))
            continue;
        const Vec3 middle = 0.5 * (mesh.point(near.p).cast<double>() + mesh.point(near.q).cast<double>());
        if (near.isolated && isBesideTube(middle, bounds.detail))
            continue;
        if (!joinPair(surface, region, near, bounds))
            continue;
        ++joined;
        if (near.isolated)
            m_tubes.push_back(middle);
    }
    return joined;
}

/// Evenly, or else by what lies nearest. What is around is done with for this pass.
bool TopologyFusion::joinPair(VerifiedMesh& surface, Region& region, const Near& near, const EdgeBounds& bounds)
{
    const Mesh& mesh = surface.mesh();
    bool hasFailed = false;
    for (Stepping stepping : {Stepping::Even, Stepping::Nearest}) {
        const std::optional<Surgery> surgery = joining(surface, near, stepping);
        if (!surgery)
            continue;
        const std::vector<Slot> around = cornersOf(mesh, surgery->removed);
        const std::optional<std::vector<Slot>> created = operate(surface, region, *surgery);
        if (!created) {
            hasFailed = true;
            continue;
        }
        if (!created->empty()) // umbrellas came apart: some may be specks
            removeSpecks(surface, region, cornersLeft(mesh, around, *created), bounds);
        for (Slot v : around)
            m_done.add(v);
        for (Slot v : *created)
            m_done.add(v);
        return true;
    }
    if (hasFailed) {
        countFailure(near.p);
        countFailure(near.q);
    }
    return false;
}

bool TopologyFusion::isBesideTube(const Vec3& middle, double detail) const
{
    const double beside = tubeDistance * detail;
    return std::ranges::any_of(m_tubes,
                               [&](const Vec3& tube) { return (tube - middle).squaredNorm() < beside * beside; });
}

std::optional<Surgery> TopologyFusion::joining(const VerifiedMesh& surface, const Near& near, Stepping stepping)
{
    const Mesh& mesh = surface.mesh();
    if (!m_mirror)
        return joinStars(mesh, near.p, near.q, stepping);
    const bool pOnPlane = m_mirror->isOnPlane(near.p), qOnPlane = m_mirror->isOnPlane(near.q);
    if (!m_mirror->isInHalf(near.p) || !m_mirror->isInHalf(near.q))
        return completed(surface, joinAcross(mesh, *m_mirror, m_mirror->isInHalf(near.p) ? near.p : near.q));
    if (pOnPlane && qOnPlane)
        return completed(surface, joinOnPlane(mesh, *m_mirror, near.p, near.q));
    if (pOnPlane || qOnPlane)
        return std::nullopt; // with the image three stars; a neighbour on the plane is near, too
    return completed(surface, joinStars(mesh, near.p, near.q, stepping));
}

/// With a mirror: together with its image.
std::optional<Surgery> TopologyFusion::completed(const VerifiedMesh& surface, const std::optional<Surgery>& half)
{
    if (!half || !m_mirror)
        return half;
    if (!m_mirror->learn(half->removed, surface.octree()))
        return std::nullopt;
    return withImage(surface.mesh(), *m_mirror, *half);
}

void TopologyFusion::countFailure(Slot v)
{
    const Slot i = m_failed.add(v);
    m_failures.resize(m_failed.size());
    ++m_failures[i];
}

/// Of what came, with the mirror.
void TopologyFusion::pairUp(const Mesh& mesh, const std::vector<Slot>& created)
{
    for (Slot v : created) {
        for (Slot w : created) {
            if (mesh.point(w) == m_mirror->imageOf(mesh.point(v)))
                m_mirror->pair(v, w);
        }
    }
}

/// Does the surgery if the mask lets it and it is sound, and returns the vertices that came. Those that went leave the
/// region; copies join it in their original's place.
std::optional<std::vector<Slot>> TopologyFusion::operate(VerifiedMesh& surface, Region& region, const Surgery& surgery)
{
    Mesh& mesh = surface.mesh();
    const std::vector<Slot> before = cornersOf(mesh, surgery.removed);
    const bool isMasked = std::ranges::any_of(before, [&](Slot v) { return mesh.isMasked(v); });
    std::vector<Slot> created;
    if (isMasked || !surface.tryOperation([&] { created = mesh.replaceFaces(surgery); }))
        return std::nullopt;
    for (std::size_t i = 0; i < created.size(); ++i) {
        const Slot original = surgery.vertices[i].original;
        if (region.contains(original) && (!m_mirror || m_mirror->isInHalf(created[i])))
            region.add(created[i], region.distance(original), region.plan(original), region.carried(original));
    }
    if (m_mirror)
        pairUp(mesh, created);
    for (Slot v : before) {
        if (!mesh.isVertex(v) && region.contains(v))
            region.remove(v);
    }
    return created;
}
} // namespace core
