#pragma once

#include "core/mesh/mesh.h"

#include <memory>

/// Models to measure on.
namespace bench
{
/// An icosahedron whose edges are cut into `cuts`: 10 cuts^2 + 2 vertices on the sphere of radius 1. Built once a
/// program.
const core::TriangleMesh& geodesicSphere(core::Slot cuts);
/// The same surface, its vertices and faces in an order without sense, the same each time.
core::TriangleMesh shuffled(const core::TriangleMesh& mesh);
/// As the program opens it: along the Morton curve, on its lattice.
std::unique_ptr<core::Mesh> opened(const core::TriangleMesh& mesh);
} // namespace bench
