#pragma once

#include "core/mesh/mesh.h"

namespace core
{
/// What Mesh::swap(delta) would leave in the delta: its elements as they are in the mesh. Cost: the delta's elements.
MeshDelta imageOf(const Mesh& mesh, const MeshDelta& delta);
/// Vertices, edges and faces of these slots as they are in the mesh, free ones too; those past the arrays' ends are
/// left out. The images of all slots, swapped into any mesh, make it this one.
MeshDelta imageOf(const Mesh& mesh, Slot first, Slot end);
/// Whether Mesh::swap(delta) keeps within the arrays, and every link that it brings.
bool canSwap(const Mesh& mesh, const MeshDelta& delta);
} // namespace core
