#pragma once

#include "core/mesh/mesh.h"

#include <memory>
#include <string>

/// Checks of a core::Mesh for tests. They use only the pair test of the engine. Cost: O(mesh) or more.
namespace mesh_asserts
{
/// Returns the mesh on its own lattice, or on the given one, in file order. Precondition: as for core::Mesh.
std::unique_ptr<core::Mesh> sculptable(core::TriangleMesh mesh);
std::unique_ptr<core::Mesh> sculptable(core::TriangleMesh mesh, core::Lattice lattice);

/// Returns the first defect of the links (loops, twins, corners, umbrellas, free slots, lattice), or an empty text.
std::string brokenLinks(const core::Mesh& mesh);

/// Returns vertices - edges + faces: 2 for each shell, minus 2 for each handle.
std::int64_t eulerNumber(const core::Mesh& mesh);

/// Returns, in ascending order, the faces that are degenerate or meet another face outside shared vertices and edges.
/// Tests all pairs exactly.
std::vector<core::Slot> badFaces(const core::Mesh& mesh);

/// Returns the live surface as a triangle mesh without unused slots.
core::TriangleMesh surfaceOf(const core::Mesh& mesh);
} // namespace mesh_asserts

/// Checks that the mesh is closed, manifold and consistently linked.
#define VERIFY_LINKED(mesh)                                                                                            \
    do {                                                                                                               \
        const std::string brokenLinks = mesh_asserts::brokenLinks(mesh);                                               \
        QVERIFY2(brokenLinks.empty(), brokenLinks.c_str());                                                            \
    } while (false)
