#pragma once

#include "core/mesh/mesh.h"

#include <memory>
#include <string>

/// Judgements of a core::Mesh for tests, made with nothing of the engine but the pair test. All O(mesh) or worse.
namespace mesh_asserts
{
/// The mesh on its own lattice, or on the given one, in the order of the file. Precondition: as for core::Mesh.
std::unique_ptr<core::Mesh> sculptable(core::TriangleMesh mesh);
std::unique_ptr<core::Mesh> sculptable(core::TriangleMesh mesh, core::Lattice lattice);

/// What is wrong with the links: loops, twins, corners, umbrellas, free slots, lattice. Empty if nothing is.
std::string brokenLinks(const core::Mesh& mesh);

/// Vertices - edges + faces: 2 a shell, less 2 a handle.
std::int64_t eulerNumber(const core::Mesh& mesh);

/// Faces that are degenerate or meet another outside shared vertices and edges, ascending: exact tests of all pairs.
std::vector<core::Slot> badFaces(const core::Mesh& mesh);

/// The live surface as a file would hold it.
core::TriangleMesh surfaceOf(const core::Mesh& mesh);
} // namespace mesh_asserts

/// Closed, manifold, consistently linked.
#define VERIFY_LINKED(mesh)                                                                                            \
    do {                                                                                                               \
        const std::string brokenLinks = mesh_asserts::brokenLinks(mesh);                                               \
        QVERIFY2(brokenLinks.empty(), brokenLinks.c_str());                                                            \
    } while (false)
