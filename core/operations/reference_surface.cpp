// The place of a vertex (after Botsch and Kobbelt 2004, who relax and project; creases and raising are added here):
//   1. sectors   its faces, divided by creases: one sector if smooth, two at a crease, more at a corner
//   2. relax     along the surface, or along the crease; a corner stays
//   3. project   onto the nearest face with a normal like the sector's, for each sector
//   4. raise     after all other steps, one vertex after another: by the depth of the edges around it

#include "core/operations/reference_surface.h"

#include "core/geometry/point_triangle.h"
#include "core/mesh/normals.h"
#include "core/sculpt/remesh/remesh.h"

#include <algorithm>

namespace core
{
namespace
{
/// A point is projected onto a face at most `farthest` (in d_detail) away. The angle between the face's normal and the
/// sector's must have at least the cosine sameSheetCosine.
constexpr double farthest = 0.5, sameSheetCosine = 0.5;
/// Fraction of `farthest` that is searched first; most faces are found within it.
constexpr double usualShare = 0.125;
/// Edges sharper than about 45 degrees (smaller cosine of the normals) are creases. If more than `maxCreases` meet, the
/// surface is rough rather than sharp.
constexpr double creaseCosine = 0.7;
constexpr std::size_t maxCreases = 4;
/// Number of rounds in which a point on a crease is projected onto each of its sides in turn. On flat sides the first
/// rounds suffice.
constexpr int projections = 3;
/// Largest distance by which a vertex is raised, in d.
constexpr double maxRaise = 0.25;
/// Height by which a vertex is raised per mean depth of its edges. Above 1 because on average half of the neighbours
/// are raised later: at a common final height h, the depth seen at a vertex's turn is h - h/4.
constexpr double heightPerDepth = 1.25;

struct Sectors
{
    std::vector<Vec3> normals;    ///< one normal per sector, of any length
    std::vector<Vec3> creaseEnds; ///< other ends of the creases at the vertex; two if there are two sectors
};

Sectors wholeStar(const Mesh& mesh, Slot v)
{
    return {{vertexNormal(mesh, v)}, {}};
}

Sectors sectorsAround(const Mesh& mesh, Slot v)
{
    std::vector<Vec3> faces, creaseEnds;
    std::vector<std::size_t> creases; // index of the first face after each crease, counter-clockwise
    mesh.forEachOutgoing(v, [&](Slot h) {
        const Vec3 after = faceNormal(mesh, mesh.face(h)), before = faceNormal(mesh, mesh.face(h ^ 1));
        if (after.dot(before) < creaseCosine * after.norm() * before.norm()) {
            creases.push_back(faces.size());
            creaseEnds.push_back(mesh.point(mesh.to(h)).cast<double>());
        }
        faces.push_back(after);
    });
    if (creases.size() < 2 || creases.size() > maxCreases)
        return wholeStar(mesh, v);
    std::vector<Vec3> normals;
    for (std::size_t i = 0; i < creases.size(); ++i) {
        const std::size_t end = i + 1 < creases.size() ? creases[i + 1] : creases[0] + faces.size();
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = creases[i]; k < end; ++k)
            sum += faces[k % faces.size()];
        normals.push_back(sum);
    }
    return {normals, creaseEnds};
}
} // namespace

ReferenceSurface::ReferenceSurface(const Mesh& mesh) : m_mesh(mesh), m_octree(mesh), m_boxes(mesh.slots().faces)
{
    for (const Slot f : m_mesh.faces())
        m_boxes[f] = boxOf(m_mesh, f);
}

std::optional<Vec3> ReferenceSurface::nearest(const Vec3& p, const Reach& reach) const
{
    const std::optional<Vec3> found = nearestWithin(p, {usualShare * reach.distance, reach.way});
    return found ? found : nearestWithin(p, reach);
}

std::optional<Vec3> ReferenceSurface::nearestWithin(const Vec3& p, const Reach& reach) const
{
    const LatticeBox box = latticeBox(m_mesh.lattice(), {p, reach.distance});
    std::optional<Vec3> best;
    double best2 = reach.distance * reach.distance;
    Slot bestFace = noSlot;
    m_octree.query(box, [&](Slot f) {
        if (!m_boxes[f].meets(box))
            return;
        const Vec3 normal = faceNormal(m_mesh, f);
        if (normal.dot(reach.way) <= sameSheetCosine * normal.norm() * reach.way.norm())
            return;
        const Triangle& t = m_mesh.corners(f);
        const auto corner = [&](int i) { return Vec3(m_mesh.point(t[i]).cast<double>()); };
        const Vec3 point = nearestInTriangle(p, {corner(0), corner(1), corner(2)});
        const double distance2 = (point - p).squaredNorm();
        if (distance2 < best2 || (distance2 == best2 && f < bestFace)) {
            best2 = distance2;
            best = point;
            bestFace = f;
        }
    });
    return best;
}

Vec3 ReferenceSurface::evenPlace(const Mesh& mesh, const EdgeBounds& bounds, Slot v) const
{
    const auto [normals, creaseEnds] = sectorsAround(mesh, v);
    const double distance = farthest * bounds.detail;
    if (normals.size() == 1) {
        const Vec3 relaxed = relaxedPlace(mesh, bounds, v);
        return nearest(relaxed, {distance, normals[0]}).value_or(relaxed);
    }
    Vec3 p = mesh.point(v).cast<double>();
    if (normals.size() == 2)
        p = 0.5 * (p + 0.5 * (creaseEnds[0] + creaseEnds[1]));
    for (int i = 0; i < projections; ++i) {
        for (const Vec3& way : normals)
            p = nearest(p, {distance, way}).value_or(p);
    }
    return p;
}

Vec3 ReferenceSurface::raisedPlace(const Mesh& mesh, const EdgeBounds& bounds, Slot v) const
{
    const Vec3 p = mesh.point(v).cast<double>();
    const Sectors sectors = sectorsAround(mesh, v);
    const double length = sectors.normals[0].norm();
    if (sectors.normals.size() > 1 || length == 0)
        return p;
    const Vec3 normal = sectors.normals[0] / length;
    const Reach reach = {farthest * bounds.detail, normal};
    double depths = 0;
    int edges = 0;
    mesh.forEachOutgoing(v, [&](Slot h) {
        const Vec3 middle = 0.5 * (p + mesh.point(mesh.to(h)).cast<double>());
        if (const auto original = nearest(middle, reach))
            depths += (*original - middle).dot(normal);
        ++edges;
    });
    const double max = maxRaise * bounds.minimum;
    return p + std::clamp(heightPerDepth * depths / edges, -max, max) * normal;
}
} // namespace core
