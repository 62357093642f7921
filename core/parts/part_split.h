#pragma once

#include "core/geometry/triangle_mesh.h"

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
} // namespace core
