#pragma once

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_patch.h"

namespace core
{
/// Returns a vertex as viewers draw it: position, normal, colour, mask, curvature and sharp edge; all zero for a free
/// slot. The result depends only on the vertex and its one-ring. Thread: any while no thread writes. Cost: O(valence).
DrawVertex drawVertex(const Mesh& mesh, Slot v);
} // namespace core
