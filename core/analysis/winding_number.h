#pragma once

#include "core/analysis/solid_angles.h"
#include "core/geometry/triangle_mesh.h"

#include <optional>

namespace core
{
/// Generalised winding number of a surface, which may be open and meet itself (Jacobson, Kavan and Sorkine-Hornung
/// 2013): 1 inside a solid, 0 outside. Counts the faces that a ray crosses, and subtracts the solid angles of curtains
/// that hang from the borders against the ray (as Martens and Bessmeltsev 2024). So closed surfaces have whole numbers.
/// A surface with many borders has the sum of its own solid angles instead. Thread: any; the object is immutable. Cost:
/// about 2 us per query and 0.02 us per border, or that of SolidAngles.
class WindingNumber
{
public:
    /// Copies the triangles. Precondition: coordinates are finite and in the range of float32. Cost: two sorts.
    WindingNumber(std::span<const Vec3> points, std::span<const Triangle> triangles);
    explicit WindingNumber(const TriangleMesh& mesh);

    /// Returns the winding number at p. Without many borders it is exact up to rounding, except for points within
    /// rounding of a face, which may be on either side. `without`: faces to leave out, ascending, all in one plane; it
    /// must contain the faces that p lies on.
    double at(const Vec3& p, std::span<const Slot> without = {}) const;

private:
    /// Returns the winding number of the surface with its curtains.
    double crossingsAt(const Vec3& p, int axis, std::span<const Slot> without) const;
    /// Returns the solid angles of the curtains, as a share of the whole sphere.
    double curtainsAt(const Vec3& p, int axis) const;

    std::vector<std::array<Vec3, 3>> m_triangles;
    std::optional<BoxTree> m_tree; ///< boxes of the triangles
    /// Directed edges along which faces run more often in this direction, once for each time.
    std::vector<std::array<Vec3, 2>> m_borders;
    std::optional<SolidAngles> m_angles; ///< if there are many borders; the other members are then empty
};
} // namespace core
