#pragma once

#include "core/geometry/box_tree.h"

#include <span>

namespace core
{
/// How often a surface winds around a point, which need not be closed (Jacobson, Kavan and Sorkine-Hornung 2013): 1
/// inside and 0 outside of a solid. Far parts are taken as dipoles (Barill, Dickson, Schmidt, Levin and Jacobson 2018):
/// off by some 0.01. Immutable: any thread. About 10 us a question.
class WindingNumber
{
public:
    /// Copies the triangles. Cost: a sort.
    WindingNumber(std::span<const Vec3> points, std::span<const Triangle> triangles);

    /// `without`: faces that are left out, as those that the point lies on must be; ascending.
    double at(const Vec3& p, std::span<const Slot> without = {}) const;

private:
    struct Dipole
    {
        Vec3 centre = Vec3::Zero(); ///< weighted by area
        Vec3 moment = Vec3::Zero(); ///< normals times areas
        double radius = 0;          ///< of the ball about the centre that holds the faces
    };
    struct Level
    {
        std::vector<Dipole> nodes; ///< each covers nodeSize of the level below
    };

    Dipole dipoleOf(std::size_t from, std::size_t to) const;

    std::vector<std::array<Vec3, 3>> m_triangles; ///< in the order of a BoxTree
    std::vector<Slot> m_faces;                    ///< and which they were
    std::vector<Level> m_levels;                  ///< the first over triangles, the last has one node
};
} // namespace core
