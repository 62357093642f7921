#include "core/io/placed_mesh.h"

#include "core/analysis/mesh_check.h"
#include "core/util/file_error.h"

namespace core
{
TriangleMesh placedMesh(const std::filesystem::path& path, TriangleMesh mesh, const Vec3& place)
{
    bool isExact = true;
    for (Vec3f& p : mesh.points) {
        const Vec3 there = p.cast<double>() + place;
        p = there.cast<float>();
        isExact = isExact && p.cast<double>() == there;
    }
    if (!isExact && !checkMesh(mesh).printReady())
        throw FileError(FileErrorKind::TooFar, path);
    return mesh;
}
} // namespace core
