// Quasi-uniform optimisation of a region (paper, section 3.2), in the paper's order:
//   0. refine:   faces under the brush with edges longer than d_detail, even if their corners are not selected
//   1. split:    edges longer than d_detail by a queue, at the midpoint           (3.2.1, Figure 5)
//   2. collapse: edges shorter than d, the shortest first, to the midpoint or an end, until no more are allowed
//                (3.2.2, Figures 6 and 7)
//   3. flip:     edges whose two opposite angles sum to more than 180 degrees     (Delaunay's criterion)
//   4. relax:    vertices around the changes, towards their neighbours' mean, along the surface
// The paper splits again after the collapses, since they may lengthen edges. Here no second round is needed. A collapse
// that would make an edge longer than d_detail is refused (RemeshPass::staysSound), and steps 3 and 4 make no edge
// longer than d_detail or shorter than d.
// All sort keys are total orders (length, then slots), so that results depend only on the mesh.

#include "core/sculpt/remesh/remesh.h"

#include "core/mesh/normals.h"
#include "core/sculpt/remesh/edge_collapse.h"
#include "core/sculpt/remesh/edge_flip.h"
#include "core/sculpt/remesh/edge_split.h"

#include <algorithm>

namespace core
{
namespace
{
/// Sine of the smallest angle that relaxation may make, 20 degrees, unless the face had a smaller one before. Dabs
/// should leave no smaller angle.
constexpr double relaxedAngleSine = 0.342;
constexpr double relaxation = 0.5;
constexpr double sharpCosine = 0.766; ///< cosine of 40 degrees; edges whose faces differ by more are sharp
constexpr double lineCosine = 0.5;    ///< cosine of 60 degrees; edges whose faces differ by more form sharp lines

/// Moves the vertex towards `place`, as far as its mask allows. Does nothing if its faces would not stay sound.
void moveVertex(RemeshPass& pass, Slot v, const Vec3& place)
{
    const Mesh& mesh = pass.mesh();
    const Vec3 p = pass.point(v);
    const Vec3 free = p + mesh.freedom(v) * (place - p);
    if (!mesh.lattice().contains(free))
        return; // the point is outside the working volume
    const Vec3f target = pass.edit().kept(v, mesh.lattice().snap(free));
    if (pass.staysSound(v, noSlot, target.cast<double>(), {relaxedAngleSine, pass.minimum2()}))
        pass.edit().move(v, target);
}

/// Does steps 1 to 4. Relaxes vertices to `place(v)`.
RemeshCounts optimise(RemeshPass& pass, bool keepsShape, const std::function<Vec3(Slot)>& place)
{
    EdgeCollapse(pass, keepsShape).collapseShortEdges(EdgeSplit(pass).splitLongEdges());
    EdgeFlip(pass).flipEdges();
    pass.changed().sort();
    for (Slot v : pass.changed().slots()) {
        if (pass.mesh().isVertex(v) && pass.region().contains(v) && !pass.isDetail(v))
            moveVertex(pass, v, place(v));
    }
    return pass.counts;
}
} // namespace

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

bool isSharp(const Mesh& mesh, Slot v)
{
    bool sharp = false;
    Vec3 right = faceNormal(mesh, mesh.face(mesh.outgoing(v) ^ 1));
    mesh.forEachOutgoing(v, [&](Slot h) {
        const Vec3 left = faceNormal(mesh, mesh.face(h)); // this face is to the right of the next outgoing edge
        sharp = sharp || left.dot(right) < sharpCosine * left.norm() * right.norm();
        right = left;
    });
    return sharp;
}

Vec3 relaxedAlongSharp(const Mesh& mesh, const EdgeBounds& bounds, Slot v)
{
    return isSharp(mesh, v) ? Vec3(mesh.point(v).cast<double>()) : relaxedPlace(mesh, bounds, v);
}

Vec3 evenedAlongLine(const Mesh& mesh, Slot v)
{
    Vec3 sum = Vec3::Zero();
    int n = 0;
    Vec3 right = faceNormal(mesh, mesh.face(mesh.outgoing(v) ^ 1));
    mesh.forEachOutgoing(v, [&](Slot h) {
        const Vec3 left = faceNormal(mesh, mesh.face(h));
        if (left.dot(right) < lineCosine * left.norm() * right.norm()) {
            sum += mesh.point(mesh.to(h)).cast<double>();
            ++n;
        }
        right = left;
    });
    const Vec3 p = mesh.point(v).cast<double>();
    return n > 1 ? Vec3(0.5 * (p + sum / n)) : p;
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
                    const EdgeBounds& bounds, RestLengths* rest)
{
    RemeshPass pass(edit, region, bounds, rest);
    EdgeSplit(pass).refine(candidates, ball);
    return pass.counts;
}

RemeshCounts splitFacesAcross(MeshEditor& edit, Region& region, std::vector<Slot>& faces, const Sphere& ball,
                              const EdgeBounds& bounds, RestLengths* rest)
{
    RemeshPass pass(edit, region, bounds, rest);
    EdgeSplit(pass).splitFacesAcross(faces, ball);
    return pass.counts;
}

RemeshCounts optimise(MeshEditor& edit, Region& region, const EdgeBounds& bounds, RestLengths* rest)
{
    RemeshPass pass(edit, region, bounds, rest);
    return optimise(pass, false, [&](Slot v) { return relaxedPlace(edit.mesh(), bounds, v); });
}

RemeshCounts optimiseKeepingShape(MeshEditor& edit, Region& region, const EdgeBounds& bounds,
                                  const std::function<Vec3(Slot)>& place, RestLengths* rest)
{
    RemeshPass pass(edit, region, bounds, rest);
    return optimise(pass, true, place);
}

void moveSoundly(MeshEditor& edit, Region& region, const EdgeBounds& bounds, const std::function<Vec3(Slot)>& place)
{
    RemeshPass pass(edit, region, bounds);
    region.forEach([&](Slot v) { moveVertex(pass, v, place(v)); });
}

RemeshCounts splitLongEdges(MeshEditor& edit, Region& region, const EdgeBounds& bounds)
{
    RemeshPass pass(edit, region, bounds);
    EdgeSplit(pass).splitLongEdges();
    return pass.counts;
}
} // namespace core
