#pragma once

#include "core/geometry/geometry.h"

#include <vector>

namespace core
{
/// A triangle mesh without connectivity and without guarantees, as read from a file. Readers return it, writers accept
/// it, and checkMesh() examines it.
struct TriangleMesh
{
    std::vector<Vec3f> points;
    std::vector<Rgb> colors; ///< empty, or one per point
    std::vector<Triangle> triangles;
    std::vector<std::uint8_t> masks = {}; ///< empty, or one per point (see Mesh::mask)
    std::vector<PartId> parts = {};       ///< empty: all points belong to part 0; or one per point
};

/// Returns the paper's sphere: an icosahedron whose faces are split in four this many times, with its points moved out
/// to the radius. Four subdivisions give 2562 vertices.
TriangleMesh icosphere(int subdivisions, double radius);
} // namespace core
