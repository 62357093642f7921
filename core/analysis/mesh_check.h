#pragma once

#include "core/analysis/mesh_topology.h"
#include "core/analysis/self_intersection.h"
#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core
{
/// The result of checking a model. Lengths are in the model's unit. A value that has no meaning for the model is
/// missing.
struct MeshReport
{
    std::size_t vertices = 0; ///< vertices that a face uses
    std::size_t unusedVertices = 0;
    std::size_t faces = 0;

    bool closed = false;   ///< no edge has only one face
    bool manifold = false; ///< no edge has more than two faces, each vertex has one umbrella
    bool oriented = false; ///< the two faces of each edge run along it in opposite directions
    /// Each shell faces outwards at even nesting depth and inwards at odd depth. Missing unless the mesh is closed,
    /// manifold and oriented, without degenerate faces or intersections.
    std::optional<bool> boundsSolid;

    std::size_t components = 0; ///< sets of faces connected by edges
    /// Sum over the components. Missing unless the mesh is closed, manifold and oriented, without degenerate faces.
    std::optional<std::int64_t> genus;
    std::optional<double> volume; ///< missing unless closed and oriented
    double area = 0;
    Vec3 size = Vec3::Zero(); ///< size of the bounding box
    double minEdge = 0, maxEdge = 0;

    Finding openEdges;           ///< edges of one face
    Finding nonManifoldEdges;    ///< edges of more than two faces
    Finding nonManifoldVertices; ///< vertices whose faces form more than one umbrella
    Finding misorientedEdges;    ///< edges whose two faces run along them in the same direction
    Finding degenerateFaces;     ///< faces without area, or with one vertex twice
    IntersectionReport intersections;

    /// An import would keep the model valid. Moved to the origin if it is too far away, and snapped to its lattice, it
    /// has no degenerate faces and no intersections. It still bounds a solid if it did before. Missing if the model as
    /// read has degenerate faces or intersections.
    std::optional<bool> latticeOk;

    bool printReady() const { return boundsSolid.value_or(false); }
};

/// Checks the float32 coordinates exactly, not snapped. Precondition: indices are in range, points are finite. Uses all
/// cores; the result does not depend on their number. Each part of a mesh with parts is checked alone, because parts
/// may overlap; the report then has the sums, and a property holds if every part has it. The result of a cancelled
/// check must not be used. Cost: about 1 s for a million faces on two cores.
MeshReport checkMesh(const TriangleMesh& mesh, const JobControl& control = {});
} // namespace core
