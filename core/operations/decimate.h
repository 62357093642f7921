#pragma once

#include "core/mesh/mesh.h"
#include "core/util/job_control.h"

namespace core
{
/// What is left of a surface.
struct Decimated
{
    TriangleMesh mesh;         ///< on the lattice; empty: it was stopped
    std::uint64_t refused = 0; ///< collapses that would have made faces meet
};

/// Fewer triangles for the same shape and colours: at most `triangles` of them, if the topology can be had with so few
/// (a shell needs four; handles and shells all stay). Closed, manifold and free of self-intersections like the mesh
/// that it starts from: each step is checked exactly. The mesh is used up. Any thread; about 20 s a million triangles,
/// on one core.
Decimated decimate(Mesh mesh, std::size_t triangles, const JobControl& control = {});
} // namespace core
