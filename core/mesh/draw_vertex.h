#pragma once

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_patch.h"

namespace core
{
/// Returns a vertex as viewers draw it: place, normal, colour, mask, curvature and sharp edge; all zero of a free slot.
/// It depends on the vertex and its neighbours only. Deterministic; any thread while nobody writes. Cost: the valence.
DrawVertex drawVertex(const Mesh& mesh, Slot v);
} // namespace core
