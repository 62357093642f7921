#pragma once

#include "core/geometry/geometry.h"

#include <vector>

namespace core
{
/// A triangle mesh as files hold it: no connectivity, no promise. What readers return, writers take, and checkMesh()
/// examines.
struct TriangleMesh
{
    std::vector<Vec3f> points;
    std::vector<Rgb> colors; ///< empty, or one per point
    std::vector<Triangle> triangles;
    std::vector<std::uint8_t> masks = {}; ///< empty, or one per point (see Mesh::mask)
};

/// The paper's sphere (subdivisions 4: 2562 vertices): an icosahedron split 1 to 4 and pushed out to the radius.
TriangleMesh icosphere(int subdivisions, double radius);
} // namespace core
