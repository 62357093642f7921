#include "core/geometry/face_geometry.h"

namespace core
{
Box boxOf(const TriangleMesh& mesh)
{
    Box box;
    for (const Triangle& t : mesh.triangles)
        for (const Slot corner : t)
            box.extend(mesh.points[corner].cast<double>());
    return box;
}

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, Slot face)
{
    const auto& [a, b, c] = mesh.triangles[face];
    return {mesh.points[a].cast<double>(), mesh.points[b].cast<double>(), mesh.points[c].cast<double>()};
}
} // namespace core
