#pragma once

#include "core/analysis/mesh_check.h"
#include "core/mesh/mesh.h"
#include "core/util/job_control.h"

#include <memory>

namespace core
{
struct BuildResult
{
    std::unique_ptr<Mesh> mesh; ///< nothing if the model was refused
    MeshReport report;          ///< of the model as it came: if it is not print-ready, that is why it was refused
    std::size_t resnapped = 0;  ///< vertices that went to a neighbouring lattice point, so that no faces meet
    /// Faces that are unsound on the lattice whatever was tried: the model was refused for them.
    std::size_t unsnappable = 0;
};

/// Makes the model sculptable: checks it exactly, places and snaps it on its lattice, lays its elements out along a
/// Morton curve and builds the links. With `centre` the middle of its box goes to the origin (see placeOnLattice); the
/// mesh's frame keeps where it was (MeshFrame::place).
/// Whole-mesh cost, on all cores; no mesh if it is cancelled. The file's order does not matter for speed afterwards.
/// `frame`: that the model had before, perhaps. If all of it lies on that lattice it is that again, and stays where it
/// is; so does its uniform detail.
BuildResult buildMesh(const TriangleMesh& model, bool centre = false, const JobControl& control = {},
                      const std::optional<MeshFrame>& frame = {});

TriangleMesh withoutUnusedVertices(const TriangleMesh& mesh);

/// The live surface, compact: vertices and faces in the order of their slots. Without colours if no vertex has been
/// coloured.
TriangleMesh extractMesh(const Mesh& mesh);
} // namespace core
