#pragma once

#include "core/mesh/mesh_frame.h"

#include <OpenMesh/Core/Mesh/ArrayItems.hh>

#include <iosfwd>
#include <type_traits>
#include <vector>

namespace core
{
/// Flag of hidden vertices, beside their part.
inline constexpr PartId hiddenBit = maxPartId + 1;

/// Before-image: the state of an element before an edit touched it. `stamp` is the element's stamp at that time (see
/// Mesh).
struct VertexImage
{
    Slot slot;
    std::uint32_t stamp;
    Vec3f point;
    Rgb color;
    std::uint8_t mask;
    bool live;
    PartId part; ///< and hiddenBit if the vertex is hidden
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

/// The other state of one edit: its elements before the edit, or after the edit once it is undone. Mesh::swap exchanges
/// the two states, so one copy serves undo and redo.
struct MeshDelta
{
    std::vector<VertexImage> vertices;
    std::vector<EdgeImage> edges;
    std::vector<FaceImage> faces;
    SlotCounts counts;          ///< lengths of the arrays in the other state
    std::uint64_t meshHash = 0; ///< Mesh::meshHash in the other state
    MeshFrame frame;            ///< frame of the mesh in the other state

    bool empty() const { return vertices.empty() && edges.empty() && faces.empty(); }
    std::size_t bytes() const;

    /// Spills a delta to disk and reads it back, within one run of the program: raw memory images, not portable.
    /// Callers must check the stream for errors.
    void write(std::ostream& out) const;
    static MeshDelta read(std::istream& in);
};
} // namespace core
