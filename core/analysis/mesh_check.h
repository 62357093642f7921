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
/// What `check` says of a model. Lengths in the model's unit. A value without meaning is missing.
struct MeshReport
{
    std::size_t vertices = 0; ///< that a face uses
    std::size_t unusedVertices = 0;
    std::size_t faces = 0;

    bool closed = false;   ///< no edge has only one face
    bool manifold = false; ///< no edge has more than two faces, each vertex has one umbrella
    bool oriented = false; ///< the two faces of each edge run it in opposite directions
    /// Each shell faces outwards at even nesting depth and inwards at odd. Missing unless closed, manifold, oriented,
    /// without degenerate faces or intersections.
    std::optional<bool> boundsSolid;

    std::size_t components = 0; ///< sets of faces connected by edges
    /// Summed over components; missing unless closed, manifold, oriented and without degenerate faces.
    std::optional<std::int64_t> genus;
    std::optional<double> volume; ///< missing unless closed and oriented
    double area = 0;
    Vec3 size = Vec3::Zero(); ///< of the bounding box
    double minEdge = 0, maxEdge = 0;

    Finding openEdges;           ///< of one face
    Finding nonManifoldEdges;    ///< of more than two
    Finding nonManifoldVertices; ///< whose faces are not all joined by edges there
    Finding misorientedEdges;    ///< of two faces that run it in the same direction
    Finding degenerateFaces;     ///< without area, or with one vertex twice
    IntersectionReport intersections;

    /// Import would keep it valid: moved to the origin if it is too far away, and snapped to its lattice, it has no
    /// degenerate faces, no intersections, and bounds a solid if it did. Missing where it has degenerate faces or
    /// intersections anyway.
    std::optional<bool> latticeOk;

    bool printReady() const { return boundsSolid.value_or(false); }
};

/// Checks the mesh's float32 coordinates exactly, not snapped. Indices in range, points finite. All cores; the result
/// does not depend on their number. If it is cancelled, the result is not usable. About 1 s a million faces on two.
MeshReport checkMesh(const TriangleMesh& mesh, const JobControl& control = {});
} // namespace core
