#pragma once

#include "core/parts/part_list.h"

namespace core
{
/// A part of a mesh as a mesh of its own.
struct PartPiece
{
    PartId part = 0;
    TriangleMesh mesh;        ///< without part labels; vertices and faces in the order of the whole mesh
    std::vector<Slot> points; ///< index of each vertex in the whole mesh
    std::vector<Slot> faces;  ///< index of each face in the whole mesh
};

/// Returns the parts of a mesh, by ascending id; a mesh without labels is one part with id 0. Vertices without a face
/// are in no piece. Precondition: the corners of each face belong to one part. Cost: O(mesh).
std::vector<PartPiece> splitByPart(const TriangleMesh& mesh);

/// Returns one mesh of all pieces, with labels if there is more than one or its part is not 0. The indices of the
/// pieces are not used.
TriangleMesh joined(const std::vector<PartPiece>& pieces);

/// Returns the list with exactly the parts that the mesh has: those of `known` in its order, then others without a name
/// by ascending id.
PartList listedParts(const TriangleMesh& mesh, const PartList& known);

/// Returns the mesh without the parts that the list hides. Cost: O(mesh).
TriangleMesh visibleParts(const TriangleMesh& mesh, const PartList& list);

/// Returns the mesh with one part after the other, in the order of listedParts(); within a part, vertices and faces
/// keep their order. A mesh without labels stays as it is; others lose vertices without a face.
TriangleMesh inListOrder(const TriangleMesh& mesh, const PartList& known);
} // namespace core
