// Vertices that the motion is about to bring into contact:
//   gather     the vertices within d_thickness of the region
//   turned     those that do not look the way that the region does on the whole: of each pair one is among them
//   pairs      no neighbours, face each other, approach each other, and would meet in a sub-step
// Two filters, as in Ginier's FreeStyle implementations: surfaces that meet from outside join whatever the tool; the
// two sides of a wall do only when they are pushed.

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
/// d_thickness in terms of d_detail: edge meets edge at most this far from vertices (notes on the paper's bound,
/// section 3.4).
constexpr double thicknessPerDetail = 0.735;
/// Normals of surfaces that face each other: at more than 135 degrees.
constexpr double facingCosine = -0.7071;
/// If all normals lie within this cone around one direction no two of them are more than 135 degrees apart.
constexpr double coneCosine = 0.3827;   // cos 67.5 degrees
constexpr double safeConeCosine = 0.39; // a little narrower: rounding does not matter then
/// A pair joins when the next sub-step would close this part of the gap or more, ...
constexpr double closingShare = 1 / 1.5;
/// ... or when the gap is below this part of d_detail and closing.
constexpr double contactPerDetail = 0.05;
/// Faces that a core takes at a time.
constexpr std::size_t facesPerChunk = 1024;

bool haveCommonNeighbour(const Mesh& mesh, Slot p, Slot q)
{
    bool found = false;
    mesh.forEachOutgoing(p, [&](Slot h) { found = found || mesh.findHalfedge(mesh.to(h), q) != noSlot; });
    return found;
}

Vec3 unit(const Vec3& v)
{
    const double length = v.norm();
    return length > 0 ? Vec3(v / length) : Vec3::Zero();
}
} // namespace

double FusionInput::reach() const
{
    return thicknessPerDetail * bounds.detail;
}

double FusionInput::detail(Slot p, Slot q) const
{
    const double finest = rest ? 2 * std::min(rest->of(p), rest->of(q)) : bounds.detail; // as d_detail is 2 d
    return std::min(finest, bounds.detail);
}

bool FusionCandidates::mayFace(const Mesh& mesh, const Region& region, std::span<const Slot> faces)
{
    std::vector<Vec3> normals(faces.size()); // exact, and so is their sum: the order of the faces does not matter
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
    gather(surface, region, input.reach());
    findTurned(surface.mesh(), region);
    findPairs(surface.mesh(), region, limits, input);
}

/// Gathers the vertices of all faces that come within reach of the region's box.
void FusionCandidates::gather(const VerifiedMesh& surface, const Region& region, double reach)
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
        m_points.push_back(mesh.point(v).cast<double>());
    m_normals.resize(m_points.size());
}

/// Vertices whose normals lie within one cone do not face each other: one of each pair has another normal.
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
    const double reach = input.reach(), reach2 = reach * reach;
    const ProximityGrid grid(m_points, reach);
    for (Slot turned : m_turned) {
        grid.forEachNear(m_points[turned], [&](Slot near) {
            const double distance2 = (m_points[near] - m_points[turned]).squaredNorm();
            if (distance2 >= reach2 || near == turned ||
                (m_isTurned[near] && near < turned)) // the last: met from the other side
                return;
            const Slot lower = std::min(near, turned), upper = std::max(near, turned);
            const bool fromLower = region.contains(m_vertices.slots()[lower]);
            const Slot i = fromLower ? lower : upper, j = fromLower ? upper : lower;
            const Slot v = m_vertices.slots()[i], other = m_vertices.slots()[j];
            if (!region.contains(v) || !mayPair(v, other) || !areFacing(mesh, i, j) ||
                !willMeet(i, j, region, limits, input))
                return;
            m_pairs.push_back({!haveCommonNeighbour(mesh, v, other), distance2, std::min(v, other), std::max(v, other),
                               (m_points[j] - m_points[i]).dot(m_normals[i]) < 0});
        });
    }
}

/// In a mirror a vertex of the half may join another of it, or its own image.
bool FusionCandidates::mayPair(Slot v, Slot other) const
{
    return !m_mirror || m_mirror->isInHalf(other) || m_mirror->imageOf(v) == other;
}

bool FusionCandidates::areFacing(const Mesh& mesh, Slot i, Slot j) const
{
    return !(m_normals[i].dot(m_normals[j]) > facingCosine) &&
           mesh.findHalfedge(m_vertices.slots()[i], m_vertices.slots()[j]) == noSlot;
}

/// Precondition: areFacing(). The region contains the first of the two.
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
    const double detail = input.detail(v, other);
    if (detail == input.bounds.detail)
        return closingShare * gap <= closing || gap <= contactPerDetail * detail;
    const double aside2 = between.squaredNorm() - gap * gap, thickness = thicknessPerDetail * detail;
    return closingShare * gap <= closing && aside2 < thickness * thickness; // folds of detail may be near each other
}

/// A patch that meets its own image does so everywhere at once. Where it has reached the plane it grows from there: a
/// new tube beside that would leave a hole in between.
void FusionCandidates::keepToSeams(const Mesh& mesh)
{
    if (!m_mirror)
        return;
    const auto meetsImage = [&](const FusionPair& pair) {
        return !m_mirror->isInHalf(pair.p) || !m_mirror->isInHalf(pair.q);
    };
    SlotSet meeting, grown; // vertices of the half
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
        return pair.isolated && meetsImage(pair) && (grown.contains(pair.p) || grown.contains(pair.q));
    });
}

void FusionCandidates::sort()
{
    std::ranges::sort(m_pairs, [](const FusionPair& a, const FusionPair& b) {
        return std::tie(a.isolated, a.distance2, a.p, a.q) < std::tie(b.isolated, b.distance2, b.p, b.q);
    });
}
} // namespace core
