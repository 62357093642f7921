#include "core/mesh/normals.h"

namespace core
{
Vec3 neighbourMean(const Mesh& mesh, Slot v)
{
    Vec3 sum = Vec3::Zero();
    int n = 0;
    // Sums of lattice coordinates are exact in a double, so their order does not matter.
    mesh.forEachOutgoing(v, [&](Slot h) {
        sum += mesh.point(mesh.to(h)).cast<double>();
        ++n;
    });
    return sum / n;
}

Vec3 vertexNormal(const Mesh& mesh, Slot v)
{
    const auto point = [&](Slot u) { return Vec3(mesh.point(u).cast<double>()); };
    const Vec3 p = point(v);
    Vec3 sum = Vec3::Zero(); // exact: spokes of up to 2^21 units, products below 2^43
    const Slot first = mesh.outgoing(v);
    Vec3 spoke = point(mesh.to(first)) - p;
    Slot h = first;
    do {
        h = mesh.rotate(h);
        const Vec3 next = point(mesh.to(h)) - p;
        sum += spoke.cross(next);
        spoke = next;
    } while (h != first);
    return sum;
}

Vec3 faceNormal(const Mesh& mesh, Slot f)
{
    const Triangle& t = mesh.corners(f);
    const Vec3 a = mesh.point(t[0]).cast<double>();
    return (mesh.point(t[1]).cast<double>() - a).cross(mesh.point(t[2]).cast<double>() - a);
}
} // namespace core
