// Topology fusion (paper, section 3.4):
//   join       vertices that the motion is about to bring into contact lose their stars, the 1-rings are connected
//     gather     the vertices within d_thickness of the region
//     near       pairs that are no neighbours, face each other, approach each other, and would meet in a sub-step
//     operate    nearest first, each judged by itself
//   separate   what can no longer be collapsed, in fuse_separate.cpp
// Two filters, as in Ginier's FreeStyle implementations: surfaces that meet from outside join whatever the tool; the two sides
// of a wall do only when they are pushed.

#include "fuse.h"

#include "deform.h"
#include "join.h"
#include "mirror_surgery.h"
#include "parallel.h"
#include "proximity_grid.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace core
{
namespace
{
/// d_thickness in terms of d_detail: edge meets edge at most this far from vertices (notes on the paper's bound, section 3.4).
constexpr double thicknessPerDetail = 0.735;
/// Normals of surfaces that face each other: at more than 135 degrees.
constexpr double facingCosine = -0.7071;
/// If all normals lie within this cone around one direction no two of them are more than 135 degrees apart.
constexpr double coneCosine = 0.3827; // cos 67.5 degrees
constexpr double safeConeCosine = 0.39; // a little narrower: rounding does not matter then
/// A pair joins when the next sub-step would close this part of the gap or more, ...
constexpr double closingShare = 1 / 1.5;
/// ... or when the gap is below this part of d_detail and closing.
constexpr double contactPerDetail = 0.05;
/// No dab begins two tubes nearer to each other than this, in terms of d_detail: the first one's seam is to get there.
constexpr double tubeDistance = 4;
/// Rounds of joining in a sub-step: a guard, the last ones join nothing.
constexpr int mostRounds = 64;
/// What a core takes at a time.
constexpr std::size_t facesPerChunk = 1024;

Vec3 pointOf(const Mesh& mesh, Slot v)
{
    return mesh.point(v).cast<double>();
}

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

bool haveCommonNeighbour(const Mesh& mesh, Slot p, Slot q)
{
    bool found = false;
    mesh.forEachOutgoing(p, [&](Slot h) { found = found || mesh.findHalfedge(mesh.to(h), q) != noSlot; });
    return found;
}

bool isMasked(const Mesh& mesh, Slot p, Slot q)
{
    return mesh.isMasked(p) || mesh.isMasked(q);
}

Vec3 unit(const Vec3& v)
{
    const double length = v.norm();
    return length > 0 ? Vec3(v / length) : Vec3::Zero();
}
} // namespace

bool Fuser::mayMeet(const Mesh& mesh, const Region& region, std::span<const Slot> faces)
{
    std::vector<Vec3> normals(faces.size()); // exact, and so is their sum: the order of the faces does not matter
    std::vector<Vec3> sums(1 + chunksOf(faces.size(), facesPerChunk), Vec3::Zero());
    forEachChunk(faces.size(), facesPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Triangle& t = mesh.corners(faces[i]);
            const Vec3 a = pointOf(mesh, t[0]);
            normals[i] = (pointOf(mesh, t[1]) - a).cross(pointOf(mesh, t[2]) - a);
            if (region.contains(t[0]))
                sums[chunk] += normals[i];
        }
    });
    const Vec3 mean = unit(std::accumulate(sums.begin(), sums.end(), Vec3(Vec3::Zero())));
    return !std::ranges::all_of(normals, [&](const Vec3& normal) {
        const double along = normal.dot(mean);
        return along > 0 && along * along >= coneCosine * coneCosine * normal.squaredNorm();
    });
}

double Approach::reach() const
{
    return thicknessPerDetail * bounds.detail;
}

bool Fuser::willMeet(const JudgedMesh& surface, const Region& region, const EdgeBounds& bounds)
{
    const Approach whole = {true, bounds, 1};
    gather(surface, region, whole.reach());
    findNear(surface.mesh(), region, {}, whole);
    return !m_near.empty();
}

/// In rounds: a seam grows stitch by stitch over all of a contact before another tube is begun, else a hole stays between.
FusionCounts Fuser::join(JudgedMesh& surface, Region& region, HeldBack& held, const Approach& approach)
{
    FusionCounts counts;
    for (int round = 0; round < mostRounds; ++round) {
        if (held.inUse())
            held.extend(region, surface.mesh()); // copies joined the region in the round before
        gather(surface, region, approach.reach());
        findNear(surface.mesh(), region, held, approach);
        if (m_mirror)
            keepToSeams(surface.mesh());
        const std::uint64_t joined = joinNear(surface, region, approach.bounds);
        if (joined == 0)
            break;
        counts.fusions += joined;
    }
    return counts;
}

std::uint64_t Fuser::joinNear(JudgedMesh& surface, Region& region, const EdgeBounds& bounds)
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
        if (!isThere || isMasked(mesh, near.p, near.q) || m_done.contains(near.p) || m_done.contains(near.q) || !mayTry(near.p) || !mayTry(near.q))
            continue;
        const Vec3 middle = 0.5 * (pointOf(mesh, near.p) + pointOf(mesh, near.q));
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
bool Fuser::joinPair(JudgedMesh& surface, Region& region, const Near& near, const EdgeBounds& bounds)
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

bool Fuser::isBesideTube(const Vec3& middle, double detail) const
{
    const double beside = tubeDistance * detail;
    return std::ranges::any_of(m_tubes,
                               [&](const Vec3& tube) { return (tube - middle).squaredNorm() < beside * beside; });
}

std::optional<Surgery> Fuser::joining(const JudgedMesh& surface, const Near& near, Stepping stepping)
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
std::optional<Surgery> Fuser::completed(const JudgedMesh& surface, const std::optional<Surgery>& half)
{
    if (!half || !m_mirror)
        return half;
    if (!m_mirror->learn(half->removed, surface.octree()))
        return std::nullopt;
    return withImage(surface.mesh(), *m_mirror, *half);
}

void Fuser::countFailure(Slot v)
{
    const Slot i = m_failed.add(v);
    m_failures.resize(m_failed.size());
    ++m_failures[i];
}

/// The vertices of all faces that come within reach of the region's box.
void Fuser::gather(const JudgedMesh& surface, const Region& region, double reach)
{
    const Mesh& mesh = surface.mesh();
    const Lattice& lattice = mesh.lattice();
    LatticeBox box;
    region.forEach([&](Slot v) { box.extend(mesh.latticePoint(v)); });
    m_vertices.clear();
    m_points.clear();
    m_normals.clear();
    if (box.empty())
        return;
    const int margin = static_cast<int>(std::min(reach / lattice.unit() + 1, double(Lattice::limit)));
    box.min.array() -= margin;
    box.max.array() += margin;
    surface.octree().query(box, [&](Slot f) {
        for (Slot v : mesh.corners(f)) {
            const LatticePoint p = mesh.latticePoint(v);
            if (box.meets({p, p}))
                m_vertices.add(v);
        }
    });
    region.forEach([&](Slot v) { m_vertices.add(v); }); // the octree need not know yet what refining has made
    m_vertices.sort();
    for (Slot v : m_vertices.slots())
        m_points.push_back(pointOf(mesh, v));
    m_normals.resize(m_points.size());
}

/// Vertices whose normals lie within one cone do not face each other: one of each pair has another normal.
void Fuser::findNear(const Mesh& mesh, const Region& region, const HeldBack& held, const Approach& approach)
{
    m_near.clear();
    findTurned(mesh, region);
    if (m_turned.empty())
        return;
    const double reach = approach.reach(), reach2 = reach * reach;
    const ProximityGrid grid(m_points, reach);
    for (Slot turned : m_turned) {
        grid.forEachNear(m_points[turned], [&](Slot near) {
            const double distance2 = (m_points[near] - m_points[turned]).squaredNorm();
            if (distance2 >= reach2 || near == turned || (m_isTurned[near] && near < turned)) // the last: met from the other side
                return;
            const Slot lower = std::min(near, turned), upper = std::max(near, turned);
            const bool fromLower = region.contains(m_vertices.slots()[lower]);
            const Slot i = fromLower ? lower : upper, j = fromLower ? upper : lower;
            const Slot v = m_vertices.slots()[i], other = m_vertices.slots()[j];
            if (!region.contains(v) || !isNamed(v, other) || !willJoin(i, j, mesh, region, held, approach))
                return;
            m_near.push_back({!haveCommonNeighbour(mesh, v, other), distance2, std::min(v, other), std::max(v, other),
                              (m_points[j] - m_points[i]).dot(m_normals[i]) < 0});
        });
    }
}

/// Those that do not look the way that the region does on the whole.
void Fuser::findTurned(const Mesh& mesh, const Region& region)
{
    Vec3 sum = Vec3::Zero();
    for (Slot i = 0; i < m_points.size(); ++i) {
        m_normals[i] = unit(vertexNormal(mesh, m_vertices.slots()[i]));
        if (region.contains(m_vertices.slots()[i]))
            sum += m_normals[i];
    }
    const Vec3 mean = unit(sum);
    m_turned.clear();
    m_isTurned.assign(m_points.size(), false);
    for (Slot i = 0; i < m_points.size(); ++i) {
        if (m_normals[i].dot(mean) < safeConeCosine) {
            m_turned.push_back(i);
            m_isTurned[i] = true;
        }
    }
}

bool Fuser::isContact(const JudgedMesh& surface, const Region& region, const Approach& approach, bool fusion,
                      const std::vector<Slot>& vertices)
{
    SlotSet& at = m_done;
    at.clear();
    for (Slot v : vertices) { // some came with what was taken back
        if (v >= surface.mesh().slots().vertices || !surface.mesh().isVertex(v))
            continue;
        if (const Slot named = m_mirror && !m_mirror->isInHalf(v) ? m_mirror->imageOf(v) : v; named != noSlot)
            at.add(named);
    }
    Approach pushing = approach;
    pushing.pushes = true; // which meets the other side of a wall, too
    gather(surface, region, approach.reach());
    findNear(surface.mesh(), region, {}, pushing);
    return std::ranges::any_of(m_near, [&](const Near& near) {
        const bool mayJoin = fusion && (approach.pushes || !near.inside) && !isMasked(surface.mesh(), near.p, near.q);
        return !mayJoin && (at.contains(near.p) || at.contains(near.q));
    });
}

/// A patch that meets its own image does so everywhere at once. Where it has reached the plane it grows from there: a new tube
/// beside that would leave a hole in between.
void Fuser::keepToSeams(const Mesh& mesh)
{
    const auto meetsImage = [&](const Near& near) {
        return !m_mirror->isInHalf(near.p) || !m_mirror->isInHalf(near.q);
    };
    SlotSet meeting, grown; // vertices of the half
    for (const Near& near : m_near) {
        if (meetsImage(near))
            meeting.add(m_mirror->isInHalf(near.p) ? near.p : near.q);
    }
    for (Slot v : meeting.slots()) {
        mesh.forEachOutgoing(v, [&](Slot h) {
            mesh.forEachOutgoing(mesh.to(h), [&](Slot g) {
                if (m_mirror->isOnPlane(mesh.to(g)))
                    grown.add(v);
            });
        });
    }
    for (std::size_t i = 0; i < grown.size(); ++i) {
        mesh.forEachOutgoing(grown.slots()[i], [&](Slot h) {
            if (meeting.contains(mesh.to(h)))
                grown.add(mesh.to(h));
        });
    }
    std::erase_if(m_near, [&](const Near& near) {
        return near.isolated && meetsImage(near) && (grown.contains(near.p) || grown.contains(near.q));
    });
}

/// In a mirror a vertex of the half may join another of it, or its own image.
bool Fuser::isNamed(Slot v, Slot other)
{
    return !m_mirror || m_mirror->isInHalf(other) || m_mirror->imageOf(v) == other;
}

bool Fuser::willJoin(Slot i, Slot j, const Mesh& mesh, const Region& region, const HeldBack& held,
                     const Approach& approach)
{
    const Slot v = m_vertices.slots()[i], other = m_vertices.slots()[j];
    const Vec3 &n = m_normals[i], &m = m_normals[j];
    if (n.dot(m) > facingCosine || mesh.findHalfedge(v, other) != noSlot)
        return false;
    const Vec3 between = m_points[j] - m_points[i];
    const double ahead = between.dot(n), back = -between.dot(m);
    const bool meetOutside = ahead > 0 && back > 0, meetInside = ahead < 0 && back < 0;
    if (!meetOutside && !(meetInside && approach.pushes))
        return false;
    const auto motion = [&](Slot w) -> Vec3 {
        return region.contains(w) ? Vec3(approach.part * held.share(region, w) * region.plan(w)) : Vec3::Zero();
    };
    const bool isImage = m_mirror && !m_mirror->isInHalf(other);
    const Vec3 otherMotion = isImage ? m_mirror->imageOf(motion(v)) : motion(other);
    const Vec3 axis = unit(meetOutside ? n - m : m - n);
    const double gap = between.dot(axis), closing = (motion(v) - otherMotion).dot(axis);
    return closing > 0 && (closingShare * gap <= closing || gap <= contactPerDetail * approach.bounds.detail);
}

/// Of what came, with the mirror.
void Fuser::pairUp(const Mesh& mesh, const std::vector<Slot>& created)
{
    for (Slot v : created) {
        for (Slot w : created) {
            if (mesh.point(w) == m_mirror->imageOf(mesh.point(v)))
                m_mirror->pair(v, w);
        }
    }
}

/// Does the surgery if the mask lets it and it is sound, and returns the vertices that came. Those that went leave the region; copies join it
/// in their original's place.
std::optional<std::vector<Slot>> Fuser::operate(JudgedMesh& surface, Region& region, const Surgery& surgery)
{
    Mesh& mesh = surface.mesh();
    const std::vector<Slot> before = cornersOf(mesh, surgery.removed);
    const bool isMasked = std::ranges::any_of(before, [&](Slot v) { return mesh.isMasked(v); });
    std::vector<Slot> created;
    if (isMasked || !surface.attempt([&] { created = mesh.replaceFaces(surgery); }))
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
