#pragma once

#include "core/geometry/triangle_mesh.h"

#include <filesystem>

namespace core
{
/// Returns a document's surface where the model's file has it, to be written. `place`: see MeshFrame. Exact for a model
/// that does not lie far from its file's origin (isFarFromOrigin). Farther away coordinates are rounded, to others than
/// the nearest where faces would meet: throws FileError::TooFar, with the path, if the surface cannot be kept sound so.
/// Cost: a pass over the points; if they are rounded, that of checkMesh(), and seldom of fitToLattice().
TriangleMesh placedMesh(const std::filesystem::path& path, TriangleMesh mesh, const Vec3& place);
} // namespace core
