#include "core/sculpt/fuse/cycle_cut.h"

#include "core/mesh/mesh.h"
#include "core/mesh/normals.h"

#include <algorithm>
#include <limits>

namespace core
{
namespace
{
/// Returns the area vector of the cycle: its normal, whose length is twice the area. Seen from the normal's tip, the
/// cycle runs anticlockwise.
Vec3 axisOf(const Mesh& mesh, std::span<const Slot> cycle)
{
    const Vec3 first = mesh.point(cycle[0]).cast<double>();
    Vec3 axis = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < cycle.size(); ++i) {
        const Vec3 p = mesh.point(cycle[i]).cast<double>(), q = mesh.point(cycle[i + 1]).cast<double>();
        axis += (p - first).cross(q - first);
    }
    return axis;
}

/// Returns whether the direction, starting at the edge, leads into the solid between the edge's two faces.
bool leadsInside(const Mesh& mesh, Slot h, const Vec3& direction)
{
    const Vec3 normal = faceNormal(mesh, mesh.face(h)), across = faceNormal(mesh, mesh.face(h ^ 1));
    const Vec3f otherSide = mesh.point(mesh.to(mesh.next(h ^ 1))) - mesh.point(mesh.to(h));
    const bool isConvex = normal.dot(otherSide.cast<double>()) < 0;
    const bool isBelow = normal.dot(direction) < 0, isBelowAcross = across.dot(direction) < 0;
    return isConvex ? isBelow && isBelowAcross : isBelow || isBelowAcross;
}

/// Returns the triangles of smallest total area that fill a polygon of three or more corners. Their orientation is that
/// of the polygon. Cost: the cube of the number of corners.
std::vector<Triangle> smallestTriangles(std::span<const Vec3> corners)
{
    const std::size_t count = corners.size();
    struct Part // the part of the polygon between two corners
    {
        double area = 0;
        std::size_t apex = 0;
    };
    std::vector<Part> parts(count * count);
    const auto part = [&](std::size_t i, std::size_t j) -> Part& { return parts[i * count + j]; };
    for (std::size_t length = 2; length < count; ++length) {
        for (std::size_t i = 0; i + length < count; ++i) {
            const std::size_t j = i + length;
            Part best{std::numeric_limits<double>::infinity(), 0};
            for (std::size_t k = i + 1; k < j; ++k) {
                const double own = (corners[k] - corners[i]).cross(corners[j] - corners[i]).norm();
                const double area = part(i, k).area + part(k, j).area + own;
                if (area < best.area)
                    best = {area, k};
            }
            part(i, j) = best;
        }
    }
    std::vector<Triangle> triangles;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, count - 1}};
    while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        if (j - i < 2)
            continue;
        const std::size_t k = part(i, j).apex;
        triangles.push_back({static_cast<Slot>(i), static_cast<Slot>(k), static_cast<Slot>(j)});
        open.insert(open.end(), {{i, k}, {k, j}});
    }
    return triangles;
}

/// Adds a cap to both copies of the cycle, which are the surgery's first vertices.
void addCaps(Surgery& surgery)
{
    const std::size_t count = surgery.vertices.size() / 2;
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i < count; ++i)
        corners.push_back((surgery.vertices[i].point + surgery.vertices[count + i].point).cast<double>());
    for (const Triangle& t : smallestTriangles(corners)) {
        surgery.faces.push_back({Surgery::newVertex(t[2]), Surgery::newVertex(t[1]), Surgery::newVertex(t[0])});
        surgery.faces.push_back(
            {Surgery::newVertex(count + t[0]), Surgery::newVertex(count + t[1]), Surgery::newVertex(count + t[2])});
    }
}

/// Returns the displacements of the cycle's vertices that move its left side back by `distance`, mm.
std::vector<Vec3> drawnBack(const Mesh& mesh, std::span<const Slot> cycle, DrawBack along, double distance)
{
    const std::size_t count = cycle.size();
    std::vector<Vec3> result(count, distance * axisOf(mesh, cycle).normalized());
    for (std::size_t i = 0; i < count && along == DrawBack::AlongSurface; ++i) {
        const Vec3f way = mesh.point(cycle[(i + 1) % count]) - mesh.point(cycle[(i + count - 1) % count]);
        result[i] = distance * vertexNormal(mesh, cycle[i]).cross(way.cast<double>()).normalized();
    }
    return result;
}
} // namespace

bool isTunnel(const Mesh& mesh, std::span<const Slot> cycle)
{
    Vec3 middle = Vec3::Zero();
    for (Slot v : cycle)
        middle += mesh.point(v).cast<double>() / static_cast<double>(cycle.size());
    std::size_t inside = 0;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
        const Slot h = mesh.findHalfedge(cycle[i], cycle[(i + 1) % cycle.size()]);
        inside += leadsInside(mesh, h, middle - mesh.point(cycle[i]).cast<double>());
    }
    return 2 * inside < cycle.size();
}

std::optional<Surgery> cutCycle(const Mesh& mesh, std::span<const Slot> cycle, DrawBack along, double gap)
{
    const std::size_t count = cycle.size();
    if (axisOf(mesh, cycle).isZero())
        return std::nullopt;
    Surgery surgery;
    surgery.nearby = cycle[0];
    // The left side of the cycle gets the first copies, the right side the others.
    const std::vector<Vec3> back = drawnBack(mesh, cycle, along, 0.5 * gap);
    for (const double side : {1.0, -1.0}) {
        for (std::size_t i = 0; i < count; ++i) {
            const Slot v = cycle[i];
            const Vec3 place = mesh.point(v).cast<double>() + side * back[i];
            surgery.vertices.push_back({mesh.lattice().snap(place), mesh.color(v), v, mesh.mask(v)});
        }
    }
    const auto copyOf = [&](Slot v, const std::vector<Slot>& left, Slot f) {
        const auto at = static_cast<std::size_t>(std::ranges::find(cycle, v) - cycle.begin());
        if (at == count)
            return v;
        return Surgery::newVertex(std::ranges::find(left, f) != left.end() ? at : at + count);
    };
    // Collects the faces left of the cycle at each vertex: from the cycle's outgoing edge, anticlockwise, to its
    // incoming edge.
    std::vector<Slot> left;
    for (std::size_t i = 0; i < count; ++i) {
        const Slot v = cycle[i], after = cycle[(i + 1) % count], before = cycle[(i + count - 1) % count];
        for (Slot h = mesh.findHalfedge(v, after); mesh.to(h) != before; h = mesh.rotate(h))
            left.push_back(mesh.face(h));
        mesh.forEachOutgoing(v, [&](Slot h) { surgery.removed.push_back(mesh.face(h)); });
    }
    std::ranges::sort(surgery.removed);
    surgery.removed.erase(std::ranges::unique(surgery.removed).begin(), surgery.removed.end());
    for (Slot f : surgery.removed) {
        Triangle t = mesh.corners(f);
        for (Slot& corner : t)
            corner = copyOf(corner, left, f);
        surgery.faces.push_back(t);
    }
    addCaps(surgery);
    if (!isSurgeryOk(mesh, surgery))
        return std::nullopt;
    return surgery;
}
} // namespace core
