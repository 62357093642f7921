#pragma once

#include "core/mesh/mesh_frame.h"

#include <OpenMesh/Core/Mesh/ArrayItems.hh>

#include <iosfwd>
#include <type_traits>
#include <vector>

namespace core
{
/// Everything of an element that the mesh keeps, as it was before an edit touched it. `stamp` is the journal's (see
/// Mesh).
struct VertexImage
{
    Slot slot;
    std::uint32_t stamp;
    Vec3f point;
    Rgb color;
    std::uint8_t mask;
    bool live;
    OpenMesh::ArrayItems::Vertex item;
};
struct EdgeImage
{
    Slot slot;
    std::uint32_t stamp;
    bool live;
    OpenMesh::ArrayItems::Edge item;
};
struct FaceImage
{
    Slot slot;
    std::uint32_t stamp;
    Triangle corners; ///< 0,0,0 if the face is free
    OpenMesh::ArrayItems::Face item;

    bool live() const { return corners[0] != corners[1]; }
};

/// Lengths of the element arrays.
struct SlotCounts
{
    Slot vertices = 0, edges = 0, faces = 0;
    friend bool operator==(const SlotCounts&, const SlotCounts&) = default;
};

/// The other side of one edit: what its elements were before it, or after it once it is undone. Mesh::swap exchanges
/// the sides, so one copy serves undo and redo.
struct MeshDelta
{
    std::vector<VertexImage> vertices;
    std::vector<EdgeImage> edges;
    std::vector<FaceImage> faces;
    SlotCounts counts;          ///< lengths of the arrays on the other side
    std::uint64_t meshHash = 0; ///< Mesh::meshHash on the other side
    MeshFrame frame;            ///< on the other side

    bool empty() const { return vertices.empty() && edges.empty() && faces.empty(); }
    std::size_t bytes() const;

    /// For spilling to disk within one run of the program: raw images, no portability. A failed stream is the caller's
    /// to see.
    void write(std::ostream& out) const;
    static MeshDelta read(std::istream& in);
};
} // namespace core
