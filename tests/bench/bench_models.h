#pragma once

#include "core/mesh/mesh.h"

#include <memory>

/// Models for benchmarks.
namespace bench
{
/// Returns an icosahedron whose edges are divided into `cuts`: 10 cuts^2 + 2 vertices on the sphere of radius 1. Each
/// size is built once per program.
const core::TriangleMesh& geodesicSphere(core::Slot cuts);
/// Returns the mesh with its vertices and faces in a random order, which is the same at each call.
core::TriangleMesh shuffled(const core::TriangleMesh& mesh);
/// Returns the mesh as the program opens it: sorted along the Morton curve, on its lattice.
std::unique_ptr<core::Mesh> opened(const core::TriangleMesh& mesh);
} // namespace bench
