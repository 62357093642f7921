#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/mesh/mesh_patch.h"

namespace core
{
/// A viewer's copy of the draw arrays in plain memory, kept up to date by patches. Thread: one.
struct DrawArrays
{
    std::vector<DrawVertex> vertices;
    std::vector<Triangle> faces; ///< a free face is 0,0,0

    /// Applies a patch. Precondition: patches of one mesh arrive in order, the first one is whole. Cost: O(values in
    /// the patch).
    void apply(const MeshPatch& patch);

    bool isFree(Slot face) const { return faces[face][0] == faces[face][1]; }
};

/// Returns draw arrays for a mesh as read from a file. A vertex normal is the area-weighted mean of the normals of its
/// faces. Thread: any. Cost: O(faces).
DrawArrays drawArraysOf(const TriangleMesh& mesh);

/// Returns the patch that replaces a viewer's draw arrays by these arrays.
MeshPatch wholePatchOf(DrawArrays arrays);
} // namespace core
