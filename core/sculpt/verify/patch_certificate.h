#pragma once

#include "core/mesh/mesh.h"

namespace core
{
/// A direction with small integer components. Its dot product with a face's normal is exact in 64 bits.
using IntegerDirection = Eigen::Matrix<std::int64_t, 3, 1>;
/// Returns an integer direction approximately parallel to v, with components up to 1023 in magnitude; zero if v is
/// zero.
IntegerDirection integerDirection(const Vec3& v);

/// A face of a patch: its corner slots and their lattice points.
struct PatchFace
{
    Triangle corners;
    std::array<LatticePoint, 3> points;
};
/// A half-edge on the boundary of a patch: its end slots and their lattice points.
struct BoundaryEdge
{
    Slot from, to;
    LatticePoint fromPoint, toPoint;
};

/// Certifies that no two of the faces meet except at shared vertices and edges. Two conditions suffice: every face has
/// a positive area in the projection along `direction`, and the boundary of the patch is one closed loop that does not
/// cross itself in that projection. Then the projection covers every point of the plane as often as the loop winds
/// around it, which is once or never. Since every face counts +1, the projection is one-to-one.
/// `boundary`: the half-edges of the faces whose opposite face is not in the patch. Returns false if a condition fails;
/// the faces may still be sound then. Exact. Cost: O(faces + b log b) for a boundary of b edges that is not too jagged.
bool certifyPatch(std::span<const PatchFace> faces, std::vector<BoundaryEdge>& boundary,
                  const IntegerDirection& direction);
/// Returns whether the first, or second, condition of certifyPatch() is met.
bool arePositive(std::span<const PatchFace> faces, const IntegerDirection& direction);
bool isSimpleLoop(std::vector<BoundaryEdge>& boundary, const IntegerDirection& direction);

/// Certifies that the faces around v do not meet except at shared vertices and edges: each has a positive area in the
/// projection along the sum of their normals, and together they go around v once. Returns false if this fails; the
/// faces may still be sound then. Exact.
bool certifyStar(const Mesh& mesh, Slot v);
} // namespace core
