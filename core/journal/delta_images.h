#pragma once

#include "core/mesh/mesh.h"

namespace core
{
/// Returns the mesh's current values of the elements in the delta: what the delta would contain after
/// Mesh::swap(delta). Cost: linear in the delta's elements.
MeshDelta imageOf(const Mesh& mesh, const MeshDelta& delta);
/// Returns images of the vertices, edges and faces in slots `first` to `end` - 1, including free slots. Slots past the
/// ends of the arrays are skipped. Swapping the images of all slots into any mesh makes it equal to this mesh.
MeshDelta imageOf(const Mesh& mesh, Slot first, Slot end);
/// Returns whether Mesh::swap(delta) would stay within the arrays, including every link in the delta.
bool canSwap(const Mesh& mesh, const MeshDelta& delta);
} // namespace core
