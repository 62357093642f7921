#pragma once

#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_mesh.h"

namespace core
{
/// Tells which points a closed surface encloses. Thread: any; the object is immutable. Cost: about 2 us per point.
class SolidInterior
{
public:
    /// Copies the triangles. Precondition: the surface is closed and free of self-intersections. Cost: one sort.
    explicit SolidInterior(const TriangleMesh& solid);

    /// Returns whether p is inside, by the parity of the faces above it (+z). Exact but for points within rounding of a
    /// face, or straight below a vertical one: these may be on either side.
    bool contains(const Vec3& p) const;

private:
    BoxTree m_tree;
    std::vector<std::array<Vec3, 3>> m_triangles; ///< in the order of the tree
};
} // namespace core
