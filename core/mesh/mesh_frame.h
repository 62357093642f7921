#pragma once

#include "core/geometry/lattice.h"

namespace core
{
/// Ratio of the uniform d_detail to the mean edge at which remeshing keeps the mean edge (Botsch and Kobbelt 2004).
inline constexpr double detailPerMeanEdge = 4.0 / 3;

/// Properties of a mesh as a whole.
struct MeshFrame
{
    Lattice lattice = Lattice();
    double uniformDetail = 0; ///< d_detail of Topology::Uniform, mm
    /// Position of the document's origin in the coordinates of the model's file, mm. A vector of the lattice when the
    /// model has just been opened.
    Vec3 place = Vec3::Zero();

    friend bool operator==(const MeshFrame&, const MeshFrame&) = default;
};
} // namespace core
