#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/mesh/mesh_patch.h"

namespace core
{
/// A viewer's copy of the draw arrays, in plain memory: what patches make of it, slot by slot. One thread.
struct DrawArrays
{
    std::vector<DrawVertex> vertices;
    std::vector<Triangle> faces; ///< a free face is 0,0,0

    /// Patches of one mesh in order, a whole one first. Cost: the patch's values.
    void apply(const MeshPatch& patch);

    bool isFree(Slot face) const { return faces[face][0] == faces[face][1]; }
};

/// Of a mesh as a file holds it: normals are the mean of the faces around a vertex, by area. Any thread. Cost: a pass
/// over the faces.
DrawArrays drawArraysOf(const TriangleMesh& mesh);

/// The patch that makes these arrays of whatever was there.
MeshPatch wholePatchOf(DrawArrays arrays);
} // namespace core
