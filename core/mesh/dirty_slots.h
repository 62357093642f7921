#pragma once

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_patch.h"
#include "core/util/sparse_index.h"

namespace core
{
/// Collects the slots of the draw arrays that changed since a patch was last taken.
class DirtySlots
{
public:
    /// Adds the slots of an edit. `dirtyFaces`: live faces that were relinked or whose corners moved, which changes the
    /// normals of their corners.
    void add(const Mesh& mesh, const TouchedSlots& touched, std::span<const Slot> dirtyFaces);
    MeshPatch take(const Mesh& mesh);

private:
    SlotSet m_vertices, m_faces;
    Slot m_vertexSlots = 0, m_faceSlots = 0; ///< lengths of the draw arrays when a patch was last taken
    std::uint64_t m_epoch = 0;
};

MeshPatch wholePatchOf(const Mesh& mesh);
} // namespace core
