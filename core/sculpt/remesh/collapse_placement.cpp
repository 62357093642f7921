// Measures how a collapse changes the shape, by
//   - the distances from the planes of the faces around the edge, a memoryless quadric (Lindstrom and Turk 1998, after
//     Garland and Heckbert 1997). They are weighted by face area and not by its square, which would nearly ignore the
//     small faces beside a crease.
//   - the normals of the faces that would share the merged vertex.

#include "core/sculpt/remesh/collapse_placement.h"

#include "core/mesh/normals.h"

#include <algorithm>

namespace core
{
namespace
{
/// Cosine of the angle beyond which two faces count as the two sides of a thin wall, about 135 degrees.
constexpr double awayCosine = -0.7;

Vec3 point(const Mesh& mesh, Slot v)
{
    return mesh.point(v).cast<double>();
}

std::vector<Vec3> unitNormalsAround(const Mesh& mesh, Slot v)
{
    std::vector<Vec3> normals;
    mesh.forEachOutgoing(v, [&](Slot h) { normals.push_back(faceNormal(mesh, mesh.face(h)).normalized()); });
    return normals;
}

double minCosine(const std::vector<Vec3>& some, const std::vector<Vec3>& others)
{
    double min = 1;
    for (const Vec3& a : some) {
        for (const Vec3& b : others)
            min = std::min(min, a.dot(b));
    }
    return min;
}
} // namespace

double planeError(const Mesh& mesh, Slot h, const Vec3& p)
{
    double sum = 0, area = 0;
    for (const Slot v : {mesh.from(h), mesh.to(h)}) {
        const Vec3 toP = p - point(mesh, v);
        mesh.forEachOutgoing(v, [&](Slot g) {
            const Vec3 normal = faceNormal(mesh, mesh.face(g));
            // product: weight times distance from the plane
            const double weight = normal.norm(), product = normal.dot(toP);
            sum += product * product / weight;
            area += weight;
        });
    }
    return sum / area;
}

bool foldsUp(const Mesh& mesh, Slot h)
{
    const std::vector<Vec3> around0 = unitNormalsAround(mesh, mesh.from(h)),
                            around1 = unitNormalsAround(mesh, mesh.to(h));
    const double together = minCosine(around0, around1);
    return together < awayCosine && together < std::min(minCosine(around0, around0), minCosine(around1, around1));
}
} // namespace core
