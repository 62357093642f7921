#pragma once

#include "core/geometry/triangle_mesh.h"

#include <filesystem>

namespace core
{
/// Returns a document's surface moved to the position that it has in the model's file, ready to be written. `place`:
/// see MeshFrame. The result is exact unless the model is far from its file's origin (isFarFromOrigin); then
/// coordinates are rounded. If rounding to the nearest float would make faces meet, other floats are chosen. Throws
/// FileError::TooFar, with the path, if no rounding keeps the surface valid. Cost: one pass over the points; if they
/// are rounded, also checkMesh(), and rarely fitToLattice().
TriangleMesh placedMesh(const std::filesystem::path& path, TriangleMesh mesh, const Vec3& place);
} // namespace core
