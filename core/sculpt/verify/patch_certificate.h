#pragma once

#include "core/mesh/mesh.h"

namespace core
{
/// A direction with small integer components: its dot product with a face's normal is exact in 64 bits.
using IntegerDirection = Eigen::Matrix<std::int64_t, 3, 1>;
/// Returns the integer direction nearest to v, with components up to 1023; zero for a zero vector.
IntegerDirection integerDirection(const Vec3& v);

/// A face of a patch: its corners, and their lattice points.
struct PatchFace
{
    Triangle corners;
    std::array<LatticePoint, 3> points; ///< by corner
};
/// A half-edge on the boundary of a patch: its ends, and their lattice points.
struct BoundaryEdge
{
    Slot from, to;
    LatticePoint fromPoint, toPoint;
};

/// Certifies that no two of the faces meet outside shared vertices and edges: each is strictly positive against one
/// direction, and their boundary is one loop that is simple in that projection. Then the projection covers each point
/// of the plane as often as the loop winds around it, once or never, and every face counts +1: it is one to one.
/// `boundary`: the half-edges of the faces whose opposite face is not among them. False says nothing. Exact.
/// Cost: O(faces + b log b) for a boundary of b edges that is not too jagged.
bool certifyPatch(std::span<const PatchFace> faces, std::vector<BoundaryEdge>& boundary,
                  const IntegerDirection& direction);
/// The two conditions of certifyPatch().
bool arePositive(std::span<const PatchFace> faces, const IntegerDirection& direction);
bool isSimpleLoop(std::vector<BoundaryEdge>& boundary, const IntegerDirection& direction);

/// Certifies the same of the faces around one vertex: each is strictly positive against the sum of their normals, and
/// they go around once. False says nothing. Exact.
bool certifyStar(const Mesh& mesh, Slot v);
} // namespace core
