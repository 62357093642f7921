#pragma once

#include "core/mesh/mesh.h"
#include "core/util/job_control.h"

namespace core
{
/// Returns a lower bound on the triangles of any surface with the same connected components and handles (Jungerman and
/// Ringel 1980). A component without handles needs 4 triangles, one with a handle 14. Precondition: the mesh is closed
/// and manifold. Cost: linear.
std::size_t fewestTriangles(const TriangleMesh& mesh);

/// Result of decimate().
struct Decimated
{
    TriangleMesh mesh;         ///< the new mesh, on the lattice; empty if the job was cancelled
    std::uint64_t refused = 0; ///< number of collapses refused because faces would have intersected
};

/// Reduces the number of triangles and keeps shape and colours: at most `triangles`, if such a surface is found. All
/// components and handles stay. At first no collapse flips a face; if that does not suffice, the shape is kept ever
/// more roughly. The limit is about fewestTriangles() for rings, for parts with few handles, and for components unless
/// a dozen of them are closely nested; the result may therefore have more than `triangles`. It is closed, manifold and
/// free of self-intersections, because each step is checked exactly. The mesh argument is consumed. Thread: any. Cost:
/// about 20 s per million triangles on one core, and up to a minute more where components, handles or close surfaces
/// obstruct each other.
Decimated decimate(Mesh mesh, std::size_t triangles, const JobControl& control = {});

/// Decimates each part of a surface alone, by the same share. Returns the parts by ascending id; an unfinished surface
/// if the job was cancelled. Precondition: the surface is print-ready, and its points are on the lattice.
TriangleMesh decimateEachPart(const TriangleMesh& mesh, const Lattice& lattice, std::size_t triangles,
                              const JobControl& control = {});
} // namespace core
