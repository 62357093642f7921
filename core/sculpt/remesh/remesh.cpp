// Quasi-uniform optimisation of a region (paper, section 3.2), in its order:
//   0. refine:   faces under the brush that are too large for it, whether or not their corners are selected
//   1. split:    edges longer than d_detail by a queue, at the midpoint           (3.2.1, Figure 5)
//   2. collapse: edges shorter than d, the shortest first, to the midpoint or an end, until no more may be
//                (3.2.2, Figures 6 and 7)
//   3. flip:     edges whose two opposite angles exceed 180 degrees together      (Delaunay's criterion)
//   4. relax:    vertices around the changes, towards their neighbours' mean, along the surface
// No step after the splits makes an edge longer than d_detail, the last two none shorter than d.
// Keys of each order are total (length, then slots), so that results depend only on the mesh.

#include "core/sculpt/remesh/remesher.h"

#include "core/mesh/normals.h"

#include <algorithm>

namespace core
{
namespace
{
/// Operations per sub-step, by the region's vertices and in all: guards against endless work, not a tuning knob.
constexpr std::uint64_t opsPerVertex = 64, minOps = 4096, maxOps = 1 << 19;
/// A step may turn a face by at most about 78 degrees (cos > 0.2: notes of El Topo's legality tests, Brochu 2009).
constexpr double minTurnCosine = 0.2;
/// The smallest angle that relaxation may make, unless there was a smaller one before: 20 degrees, the least that a dab
/// should leave.
constexpr double relaxedAngleSine = 0.342;
constexpr double relaxation = 0.5;
constexpr double sharpCosine = 0.766; ///< of 40 degrees between two faces

/// Twice a triangle's area, and the squared sine of its smallest angle: the one between the two longest sides.
struct Shape
{
    Vec3 normal;
    double area2; ///< the normal's squared length
    double smallestSine2;
};

Shape shapeOf(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = (b - a).cross(c - a);
    const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
    const double shortest = std::min({ab, bc, ca});
    const double longest = shortest == ab ? bc * ca : shortest == bc ? ca * ab : ab * bc;
    const double area2 = normal.squaredNorm();
    return {normal, area2, longest > 0 ? area2 / longest : 0};
}
} // namespace

Remesher::Remesher(MeshEditor& edit, Region& region, const EdgeBounds& bounds, bool keepsShape)
    : m_edit(edit)
    , m_mesh(edit.mesh())
    , m_region(region)
    , m_detail2(bounds.detail * bounds.detail)
    , m_minimum2(bounds.minimum * bounds.minimum)
    , m_opsLeft(std::min(maxOps, minOps + opsPerVertex * region.size()))
    , m_changed(region.remeshed())
    , m_keepsShape(keepsShape)
{
    m_changed.clear();
}

bool Remesher::mayGoOn()
{
    if (m_opsLeft == 0) {
        counts.capped = true;
        return false;
    }
    --m_opsLeft;
    return true;
}

RemeshEdge Remesher::edgeAt(Slot e) const
{
    const Slot a = m_mesh.to(2 * e), b = m_mesh.to(2 * e + 1);
    return {length2(e), std::min(a, b), std::max(a, b), e};
}

/// Whether the faces around v, but those with `ignored`, stay sound when v moves to the target.
bool Remesher::staysSound(Slot v, Slot ignored, const Vec3& target, const Limits& limits) const
{
    bool sound = true;
    const Vec3 p = point(v);
    m_mesh.forEachOutgoing(v, [&](Slot h) {
        const Slot b = m_mesh.to(h), c = m_mesh.to(m_mesh.next(h));
        if (!sound || b == ignored || c == ignored)
            return;
        const Vec3 pb = point(b), pc = point(c);
        const Shape before = shapeOf(p, pb, pc), after = shapeOf(target, pb, pc);
        const double turn = before.normal.dot(after.normal);
        const double before2 = (p - pb).squaredNorm(), after2 = (target - pb).squaredNorm();
        if (turn <= 0 || turn * turn <= minTurnCosine * minTurnCosine * before.area2 * after.area2 ||
            after.smallestSine2 <
                std::min(limits.angleSine * limits.angleSine, limits.keptSliver2 * before.smallestSine2) ||
            after2 > std::max(m_detail2, before2) || after2 < std::min(limits.shortest2, before2))
            sound = false;
    });
    return sound;
}

// --- 4. relax

void Remesher::relax(const std::function<Vec3(Slot)>& place)
{
    m_changed.sort();
    for (Slot v : m_changed.slots()) {
        if (m_mesh.isVertex(v) && m_region.contains(v))
            moveVertex(v, place(v));
    }
}

void Remesher::moveTo(const std::function<Vec3(Slot)>& place)
{
    m_region.forEach([&](Slot v) { moveVertex(v, place(v)); });
}

void Remesher::moveVertex(Slot v, const Vec3& place)
{
    const Lattice& lattice = m_mesh.lattice();
    const Vec3 p = point(v);
    const Vec3 free = p + m_mesh.freedom(v) * (place - p);
    if (!lattice.contains(free))
        return; // along the surface, but past the wall of the volume
    const Vec3f target = m_edit.kept(v, lattice.snap(free));
    if (staysSound(v, noSlot, target.cast<double>(), {relaxedAngleSine, m_minimum2}))
        m_edit.move(v, target);
}

// --- what remesh.h offers

Vec3 relaxedPlace(const Mesh& mesh, const EdgeBounds& bounds, Slot v)
{
    const auto point = [&](Slot u) { return Vec3(mesh.point(u).cast<double>()); };
    Vec3 sum = Vec3::Zero();
    int n = 0;
    mesh.forEachOutgoing(v, [&](Slot h) {
        sum += point(mesh.to(h));
        ++n;
    });
    const Vec3 p = point(v), normal = vertexNormal(mesh, v);
    Vec3 step = relaxation * (sum / n - p);
    const double squared = normal.squaredNorm();
    if (squared > 0)
        step -= step.dot(normal) / squared * normal;
    const double longest2 = 0.25 * bounds.minimum * bounds.minimum;
    const double step2 = step.squaredNorm();
    return step2 > longest2 ? Vec3(p + std::sqrt(longest2 / step2) * step) : Vec3(p + step);
}

Vec3 relaxedAlongSharp(const Mesh& mesh, const EdgeBounds& bounds, Slot v)
{
    bool sharp = false;
    Vec3 right = faceNormal(mesh, mesh.face(mesh.outgoing(v) ^ 1));
    mesh.forEachOutgoing(v, [&](Slot h) {
        const Vec3 left = faceNormal(mesh, mesh.face(h)); // lies to the right of the next one
        sharp = sharp || left.dot(right) < sharpCosine * left.norm() * right.norm();
        right = left;
    });
    return sharp ? Vec3(mesh.point(v).cast<double>()) : relaxedPlace(mesh, bounds, v);
}

RemeshCounts& RemeshCounts::operator+=(const RemeshCounts& more)
{
    splits += more.splits;
    collapses += more.collapses;
    flips += more.flips;
    capped = capped || more.capped;
    blocked.insert(blocked.end(), more.blocked.begin(), more.blocked.end());
    return *this;
}

RemeshCounts refine(MeshEditor& edit, Region& region, std::span<const Slot> candidates, const Sphere& ball,
                    const EdgeBounds& bounds)
{
    Remesher remesher(edit, region, bounds);
    remesher.refine(candidates, ball);
    return remesher.counts;
}

RemeshCounts optimise(MeshEditor& edit, Region& region, const EdgeBounds& bounds)
{
    Remesher remesher(edit, region, bounds);
    remesher.collapseShortEdges(remesher.splitLongEdges());
    remesher.flipEdges();
    remesher.relax([&](Slot v) { return relaxedPlace(edit.mesh(), bounds, v); });
    return remesher.counts;
}

RemeshCounts optimiseKeepingShape(MeshEditor& edit, Region& region, const EdgeBounds& bounds,
                                  const std::function<Vec3(Slot)>& place)
{
    Remesher remesher(edit, region, bounds, true);
    remesher.collapseShortEdges(remesher.splitLongEdges());
    remesher.flipEdges();
    remesher.relax(place);
    return remesher.counts;
}

void moveSoundly(MeshEditor& edit, Region& region, const EdgeBounds& bounds, const std::function<Vec3(Slot)>& place)
{
    Remesher(edit, region, bounds).moveTo(place);
}

RemeshCounts splitLongEdges(MeshEditor& edit, Region& region, const EdgeBounds& bounds)
{
    Remesher remesher(edit, region, bounds);
    remesher.splitLongEdges();
    return remesher.counts;
}
} // namespace core
