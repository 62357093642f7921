#pragma once

#include "core/geometry/lattice.h"
#include "core/parts/part_list.h"

namespace core
{
/// Uniform d_detail, as a multiple of the mean edge, with which remeshing leaves the mean edge length as it is (Botsch
/// and Kobbelt 2004).
inline constexpr double detailPerMeanEdge = 4.0 / 3;

/// Properties of a mesh as a whole.
struct MeshFrame
{
    Lattice lattice = Lattice();
    double uniformDetail = 0; ///< d_detail of Topology::Uniform, mm
    /// Position of the document's origin in the coordinates of the model's file, mm. A vector of the lattice when the
    /// model has just been opened.
    Vec3 place = Vec3::Zero();
    PartList parts = {}; ///< every vertex belongs to one of these parts

    friend bool operator==(const MeshFrame&, const MeshFrame&) = default;
};
} // namespace core
