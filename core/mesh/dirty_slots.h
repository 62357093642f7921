#pragma once

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_patch.h"
#include "core/util/sparse_index.h"

namespace core
{
/// Which slots of the draw arrays changed since a patch was last taken.
class DirtySlots
{
public:
    /// `dirtyFaces`: alive, relinked or with a moved corner: their corners' normals changed.
    void add(const Mesh& mesh, const TouchedSlots& touched, std::span<const Slot> dirtyFaces);
    MeshPatch take(const Mesh& mesh);

private:
    SlotSet m_vertices, m_faces;
    Slot m_vertexSlots = 0, m_faceSlots = 0; ///< lengths of the draw arrays when a patch was last taken
    std::uint64_t m_epoch = 0;
};

MeshPatch wholePatchOf(const Mesh& mesh);
} // namespace core
