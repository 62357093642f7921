#pragma once

#include "core/analysis/mesh_check.h"
#include "core/mesh/mesh.h"
#include "core/util/job_control.h"

#include <memory>

namespace core
{
struct BuildResult
{
    std::unique_ptr<Mesh> mesh; ///< null if the model was refused
    /// Check of the model as read; a model that is not print-ready is refused for what the report contains.
    MeshReport report;
    std::size_t resnapped = 0; ///< vertices moved to a neighbouring lattice point to avoid intersections
    /// Number of faces that no retry made valid on the lattice. If it is not 0, the model is refused.
    std::size_t unsnappable = 0;
};

/// Makes a model sculptable: checks it exactly, moves and snaps it to a lattice, sorts its elements along a Morton
/// curve and builds the connectivity. The order of the file does not affect later speed.
/// `centre`: moves the middle of the model's box to the origin (see placeOnLattice); MeshFrame::place keeps the old
/// position.
/// `frame`: the frame that the model had before, if any. If all its points are on the frame's lattice, the model keeps
/// lattice, place and uniform detail. Parts of the model keep their properties in the frame in any case.
/// Returns no mesh if it is cancelled. Cost: O(mesh), on all cores.
BuildResult buildMesh(const TriangleMesh& model, bool centre = false, const JobControl& control = {},
                      const std::optional<MeshFrame>& frame = {});

TriangleMesh withoutUnusedVertices(const TriangleMesh& mesh);

/// Returns the live surface without gaps: vertices and faces in the order of their slots. Has no colours if every
/// vertex has the default colour, no masks if every mask is 0, and no parts if every vertex
/// belongs to part 0.
TriangleMesh extractMesh(const Mesh& mesh);
} // namespace core
