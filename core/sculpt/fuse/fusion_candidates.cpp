// Finds the pairs of vertices that the motion is about to bring into contact (paper, section 3.4):
//   gather     collects the vertices in the region's box, grown by d_thickness
//   turned     finds the vertices whose normals are outside a cone around the region's mean normal; every pair contains
//              at least one of them
//   pairs      finds vertices that are not neighbours, face each other, approach each other, and would meet in the next
//              transaction
// Surfaces that meet from outside join with any tool. The two sides of a wall join only if the tool pushes.

#include "core/sculpt/fuse/fusion_candidates.h"

#include "core/geometry/proximity_grid.h"
#include "core/mesh/normals.h"
#include "core/util/parallel.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace core
{
namespace
{
/// Two vertices face each other if the cosine of the angle between their normals is below this: more than 135 degrees.
constexpr double facingCosine = -0.7071;
/// Cosine of the half-angle of a cone. If all normals are within such a cone around one direction, no two of them are
/// more than 135 degrees apart.
constexpr double coneCosine = 0.3827;   // cos 67.5 degrees
constexpr double safeConeCosine = 0.39; // slightly narrower, so that rounding errors do not matter
/// A pair counts as meeting if the next sub-step closes at least this share of its gap.
constexpr double closingShare = 1 / 1.5;
/// A pair whose gap is below this (d_detail) counts as meeting if the next sub-step closes any of the gap.
constexpr double contactPerDetail = 0.05;
/// Faces per parallel chunk.
constexpr std::size_t facesPerChunk = 1024;

bool haveCommonNeighbour(const Mesh& mesh, Slot p, Slot q)
{
    bool found = false;
    mesh.forEachOutgoing(p, [&](Slot h) { found = found || mesh.findHalfedge(mesh.to(h), q) != noSlot; });
    return found;
}

/// Returns the smallest dot product of `normal` and any vector in the box.
double minCosine(const Vec3& normal, const Box& box)
{
    return normal.cwiseProduct(box.min()).cwiseMin(normal.cwiseProduct(box.max())).sum();
}

Vec3 unit(const Vec3& v)
{
    const double length = v.norm();
    return length > 0 ? Vec3(v / length) : Vec3::Zero();
}
} // namespace

double FusionInput::detail(Slot v) const
{
    return rest ? std::min(2 * rest->of(v), bounds.detail)
                : bounds.detail; // the rest length is taken for d, and d_detail is 2 d
}

bool FusionCandidates::mayFace(const Mesh& mesh, const Region& region, std::span<const Slot> faces)
{
    // exact vectors with an exact sum, so the order of the faces does not matter
    std::vector<Vec3> normals(faces.size());
    std::vector<Vec3> sums(1 + chunksOf(faces.size(), facesPerChunk), Vec3::Zero());
    forEachChunk(faces.size(), facesPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            normals[i] = faceNormal(mesh, faces[i]);
            if (region.contains(mesh.corners(faces[i])[0]))
                sums[chunk] += normals[i];
        }
    });
    const Vec3 mean = unit(std::accumulate(sums.begin(), sums.end(), Vec3(Vec3::Zero())));
    return !std::ranges::all_of(normals, [&](const Vec3& normal) {
        const double along = normal.dot(mean);
        return along > 0 && along * along >= coneCosine * coneCosine * normal.squaredNorm();
    });
}

void FusionCandidates::find(const VerifiedMesh& surface, const Region& region, const MotionLimits& limits,
                            const FusionInput& input)
{
    gather(surface, region, input.bounds.thickness());
    findTurned(surface.mesh(), region);
    findPairs(surface.mesh(), region, limits, input);
}

/// Gathers the vertices of the region, and all vertices in its bounding box grown by d_thickness.
void FusionCandidates::gather(const VerifiedMesh& surface, const Region& region, double thickness)
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
    const int margin = static_cast<int>(std::min(thickness / lattice.unit() + 1, double(Lattice::limit)));
    box.min.array() -= margin;
    box.max.array() += margin;
    surface.octree().query(box, [&](Slot f) {
        for (Slot v : mesh.corners(f)) {
            const LatticePoint p = mesh.latticePoint(v);
            if (box.meets({p, p}))
                m_vertices.add(v);
        }
    });
    // the octree may not contain vertices that refining has just created
    region.forEach([&](Slot v) { m_vertices.add(v); });
    m_vertices.sort();
    for (Slot v : m_vertices.slots())
        m_points.push_back(mesh.point(v).cast<double>());
    m_normals.resize(m_points.size());
}

/// Finds the vertices whose normals are outside a cone around the region's mean normal. Vertices inside the cone do not
/// face each other, so every pair contains a vertex outside it.
void FusionCandidates::findTurned(const Mesh& mesh, const Region& region)
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

void FusionCandidates::findPairs(const Mesh& mesh, const Region& region, const MotionLimits& limits,
                                 const FusionInput& input)
{
    m_pairs.clear();
    if (m_turned.empty())
        return;
    const ProximityGrid grid(m_points, input.bounds.thickness());
    std::vector<Box> normals(grid.cells());
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
        for (Slot i : grid.pointsIn(cell))
            normals[cell].extend(m_normals[i]);
    }
    double maxMotion = 0;
    region.forEach([&](Slot v) { maxMotion = std::max(maxMotion, limits.share(region, v) * region.plan(v).norm()); });
    maxMotion *= input.part;
    for (Slot turned : m_turned) {
        grid.forEachCellIn(partnersBox(turned, maxMotion, input), [&](Slot cell) {
            if (minCosine(m_normals[turned], normals[cell]) > facingCosine)
                return; // no vertex in the cell faces this one
            m_visits += grid.pointsIn(cell).size();
            for (Slot candidate : grid.pointsIn(cell))
                addPair(mesh, region, limits, input, turned, candidate);
        });
    }
}

/// Adds the pair of a turned vertex and another vertex, if they are about to meet.
void FusionCandidates::addPair(const Mesh& mesh, const Region& region, const MotionLimits& limits,
                               const FusionInput& input, Slot turned, Slot candidate)
{
    const double distance2 = (m_points[candidate] - m_points[turned]).squaredNorm(),
                 thickness = input.bounds.thickness();
    if (distance2 >= thickness * thickness || candidate == turned ||
        (m_isTurned[candidate] && candidate < turned)) // a pair of two turned vertices is examined only once
        return;
    const Slot lower = std::min(candidate, turned), upper = std::max(candidate, turned);
    const bool fromLower = region.contains(m_vertices.slots()[lower]);
    const Slot i = fromLower ? lower : upper, j = fromLower ? upper : lower;
    const Slot v = m_vertices.slots()[i], other = m_vertices.slots()[j];
    if (!region.contains(v) || !mayPair(v, other) || !areFacing(mesh, i, j) || !willMeet(i, j, region, limits, input))
        return;
    m_pairs.push_back({!haveCommonNeighbour(mesh, v, other), distance2, std::min(v, other), std::max(v, other),
                       (m_points[j] - m_points[i]).dot(m_normals[i]) < 0});
}

/// Returns a box that contains all vertices that may be about to meet vertex i. They are within d_thickness. On a mesh
/// finer than the brush, they are also within the gap that two vertices can close, and within the sideways distance
/// that willMeet() allows. The gap is measured along an axis at most 22.5 degrees from i's normal. `maxMotion`: longest
/// motion of a vertex in the next sub-step, mm.
Box FusionCandidates::partnersBox(Slot i, double maxMotion, const FusionInput& input) const
{
    const Vec3 &p = m_points[i], &n = m_normals[i];
    const double thickness = input.bounds.thickness(), detail = input.detail(m_vertices.slots()[i]);
    const Box reach(p - Vec3::Constant(thickness), p + Vec3::Constant(thickness));
    if (detail >= input.bounds.detail)
        return reach;
    constexpr double sine = 0.3827; // sine of 22.5 degrees, rounded up
    const double gap = 2 * maxMotion / closingShare, aside = EdgeBounds::thicknessPerDetail * detail;
    const double along = gap + sine * aside, across = sine * gap + aside;
    Box box(p, p);
    box.extend(p + along * n);
    if (input.pushes)
        box.extend(p - along * n);
    box.min().array() -= across;
    box.max().array() += across;
    return box.intersection(reach);
}

/// Returns whether the mirror allows the two vertices to join: both are on the positive side, or one is the other's
/// image. Precondition: v is on the positive side.
bool FusionCandidates::mayPair(Slot v, Slot other) const
{
    return !m_mirror || m_mirror->isInHalf(other) || m_mirror->imageOf(v) == other;
}

bool FusionCandidates::areFacing(const Mesh& mesh, Slot i, Slot j) const
{
    return !(m_normals[i].dot(m_normals[j]) > facingCosine) &&
           mesh.findHalfedge(m_vertices.slots()[i], m_vertices.slots()[j]) == noSlot;
}

/// Returns whether the next sub-step would bring two vertices into contact. The paper (section 3.4) joins two vertices
/// if the distance of their final positions is below d_thickness. Here their present distance is below it. The next
/// sub-step must close most of the gap along the mean axis of their normals, or any part of a gap that is nearly
/// closed. So vertices that slide past each other or move apart do not join. Preconditions: areFacing(), and the region
/// contains vertex i.
bool FusionCandidates::willMeet(Slot i, Slot j, const Region& region, const MotionLimits& limits,
                                const FusionInput& input) const
{
    const Slot v = m_vertices.slots()[i], other = m_vertices.slots()[j];
    const Vec3 &n = m_normals[i], &m = m_normals[j];
    const Vec3 between = m_points[j] - m_points[i];
    const double ahead = between.dot(n), back = -between.dot(m);
    const bool meetOutside = ahead > 0 && back > 0, meetInside = ahead < 0 && back < 0;
    if (!meetOutside && !(meetInside && input.pushes))
        return false;
    const auto motion = [&](Slot w) -> Vec3 {
        return region.contains(w) ? Vec3(input.part * limits.share(region, w) * region.plan(w)) : Vec3::Zero();
    };
    const bool isImage = m_mirror && !m_mirror->isInHalf(other);
    const Vec3 otherMotion = isImage ? m_mirror->imageOf(motion(v)) : motion(other);
    const Vec3 axis = unit(meetOutside ? n - m : m - n);
    const double gap = between.dot(axis), closing = (motion(v) - otherMotion).dot(axis);
    if (!(closing > 0))
        return false;
    const double detail = std::min(input.detail(v), input.detail(other));
    if (detail == input.bounds.detail)
        return closingShare * gap <= closing || gap <= contactPerDetail * detail;
    const double aside2 = between.squaredNorm() - gap * gap, thickness = EdgeBounds::thicknessPerDetail * detail;
    // the sideways distance is limited too, because fine folds may be close to each other without meeting
    return closingShare * gap <= closing && aside2 < thickness * thickness;
}

/// A patch meets its mirror image everywhere at once. Once joins have connected the two at the plane, further joins are
/// to widen that tunnel. Starting a new tunnel beside it would leave a hole between the two.
void FusionCandidates::dropTunnelsBesideJoins(const Mesh& mesh)
{
    if (!m_mirror)
        return;
    const auto meetsImage = [&](const FusionPair& pair) {
        return !m_mirror->isInHalf(pair.p) || !m_mirror->isInHalf(pair.q);
    };
    // meeting: vertices on the positive side that meet their image; grown: those connected to existing joins
    SlotSet meeting, grown;
    for (const FusionPair& pair : m_pairs) {
        if (meetsImage(pair))
            meeting.add(m_mirror->isInHalf(pair.p) ? pair.p : pair.q);
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
    std::erase_if(m_pairs, [&](const FusionPair& pair) {
        return pair.startsTunnel && meetsImage(pair) && (grown.contains(pair.p) || grown.contains(pair.q));
    });
}

void FusionCandidates::sort()
{
    std::ranges::sort(m_pairs, [](const FusionPair& a, const FusionPair& b) {
        return std::tie(a.startsTunnel, a.distance2, a.p, a.q) < std::tie(b.startsTunnel, b.distance2, b.p, b.q);
    });
}
} // namespace core
