#pragma once

#include "core/mesh/mesh.h"
#include "core/util/job_control.h"

namespace core
{
/// Returns a bound from below of the triangles of any surface with the same shells and handles (Jungerman and Ringel
/// 1980): a shell without handles needs 4, one with a handle 14. The mesh is closed and manifold. Linear.
std::size_t fewestTriangles(const TriangleMesh& mesh);

/// What is left of a surface.
struct Decimated
{
    TriangleMesh mesh;         ///< on the lattice; empty: it was stopped
    std::uint64_t refused = 0; ///< collapses that would have made faces meet
};

/// Fewer triangles for the same shape and colours: at most `triangles` of them, if such a surface is found. Handles and
/// shells all stay. As long as that is enough, no collapse turns a face over; below, the form is kept ever more
/// roughly, down to about what fewestTriangles() says for rings and parts with few handles, and for shells unless a
/// dozen of them lie close in each other. Where that ends above the number, the result has more. Closed, manifold and
/// free of self-intersections like the mesh that it starts from: each step is checked exactly. The mesh is used up. Any
/// thread; about 20 s a million triangles, on one core, and up to a minute more where shells, handles or sheets that
/// lie close to each other are in the way.
Decimated decimate(Mesh mesh, std::size_t triangles, const JobControl& control = {});
} // namespace core
