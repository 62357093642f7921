#pragma once

#include "mesh.h"
#include "mesh_check.h"

#include <memory>

namespace core
{
struct BuildOptions
{
    /// Puts the centre of the bounding box (snapped) at the origin. Without it a model is moved there only if its centre is
    /// farther from the origin than four times its size, where the lattice would be too coarse for it.
    bool centre = false;
};

struct BuildResult
{
    std::unique_ptr<Mesh> mesh;   ///< nothing if the model was refused
    MeshReport report;            ///< of the model as it came: if it is not print-ready, that is why it was refused
    Vec3 moved = Vec3::Zero();    ///< was added to each point
    std::size_t resnapped = 0;    ///< vertices that went to a neighbouring lattice point, so that no faces meet
    std::size_t unsnappable = 0;  ///< faces that meet on the lattice whatever was tried: the model was refused for them
};

/// Makes the model sculptable: judges it exactly, moves and snaps it to its lattice, lays its elements out along a Morton
/// curve and builds the links. Whole-mesh cost, on all cores. The file's order does not matter for speed afterwards.
BuildResult buildMesh(const TriangleMesh& model, const BuildOptions& options = {});

/// The live surface, compact: vertices and faces in the order of their slots.
TriangleMesh extractMesh(const Mesh& mesh);
} // namespace core
