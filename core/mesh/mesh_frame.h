#pragma once

#include "core/geometry/lattice.h"

namespace core
{
/// The d_detail of a mesh that is to stay as fine as it is, in terms of its mean edge (Botsch and Kobbelt 2004).
inline constexpr double detailPerMeanEdge = 4.0 / 3;

/// What a mesh keeps as a whole.
struct MeshFrame
{
    Lattice lattice = Lattice();
    double uniformDetail = 0; ///< d_detail of Topology::Uniform, in the document's unit
    /// The place of the document's origin in the space of the model's file, in the document's unit. On the lattice when
    /// the model is opened.
    Vec3 place = Vec3::Zero();

    friend bool operator==(const MeshFrame&, const MeshFrame&) = default;
};
} // namespace core
