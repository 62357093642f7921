#pragma once

#include "core/geometry/box_tree.h"

#include <span>

namespace core
{
/// Sum of the solid angles of any triangles. Distant ones are approximated by dipoles (Barill, Dickson, Schmidt, Levin
/// and Jacobson 2018), with an error of about 0.01 of the whole sphere, rarely 0.05. Thread: any; the object is
/// immutable. Cost: 3 to 20 us per query, more inside tangles of large faces.
class SolidAngles
{
public:
    /// Copies the triangles. Cost: one sort.
    SolidAngles(std::span<const Vec3> points, std::span<const Triangle> triangles);

    /// Returns the sum as seen from p, as a share of the whole sphere; positive for triangles whose normal points away
    /// from p. `without`: triangles to leave out, ascending; it must contain those that p lies on.
    double at(const Vec3& p, std::span<const Slot> without = {}) const;

private:
    struct Dipole
    {
        Vec3 centre = Vec3::Zero(); ///< mean of the faces' centres, weighted by area
        Vec3 moment = Vec3::Zero(); ///< sum of the faces' unit normals times areas
        double reach2 = 0;          ///< squared distance from the centre beyond which the dipole stands for the faces
    };
    struct Level
    {
        std::vector<Dipole> nodes;
    };

    Dipole dipoleOf(std::size_t from, std::size_t to) const;

    std::vector<std::array<Vec3, 3>> m_triangles; ///< triangles in the order of a BoxTree
    std::vector<Slot> m_faces;                    ///< original face of each triangle
    /// The first level has a node for each triangle; nodes of the others cover eight of the level below. The last has
    /// one node.
    std::vector<Level> m_levels;
};
} // namespace core
