#pragma once

#include "core/geometry/triangle_mesh.h"

namespace core
{
/// Returns a box around the origin whose faces are grids. `cells`: number of cells along each axis; even and above 0.
/// Symmetric about the planes x, y and z = 0, bit for bit. The same bits on every machine.
TriangleMesh gridBox(const std::array<int, 3>& cells, const Vec3& sizes);

/// Adds the quad a, b, c, d (counter-clockwise) as two triangles. The diagonal alternates with `even`, so that the
/// pattern is its own mirror image.
void addQuad(TriangleMesh& mesh, const std::array<Slot, 4>& q, bool even);
} // namespace core
