#pragma once

#include "core/mesh/mesh.h"
#include "core/util/job_control.h"

namespace core
{
/// Counts of the edges that could not be collapsed, by what stood in the way.
struct CollapseObstacles
{
    std::size_t topology = 0; ///< a handle or a part would go
    std::size_t shape = 0;    ///< a face would turn over or become a sliver, or faces would meet
};

/// What is left of a surface.
struct Decimated
{
    TriangleMesh mesh;           ///< on the lattice; empty: it was stopped
    std::uint64_t refused = 0;   ///< collapses that would have made faces meet
    CollapseObstacles obstacles; ///< if it has more triangles than were asked for
};

/// Fewer triangles for the same shape and colours: at most `triangles` of them, if such a surface is found. Handles and
/// shells all stay (a shell needs four triangles, a ring about eighteen), and no collapse turns a face over; where that
/// ends it above the number, the result has more, and `obstacles` tells why. Closed, manifold and free of
/// self-intersections like the mesh that it starts from: each step is checked exactly. The mesh is used up. Any thread;
/// about 20 s a million triangles, on one core.
Decimated decimate(Mesh mesh, std::size_t triangles, const JobControl& control = {});
} // namespace core
