#pragma once

#include "core/mesh/mesh.h"

namespace core
{
/// Returns the area-weighted normal of a vertex, not normalised, mm^2; zero if the areas around the vertex cancel. An
/// exact sum of products of lattice coordinates, so the order of the faces does not matter.
Vec3 vertexNormal(const Mesh& mesh, Slot v);

/// Returns the normal of a face; its length is twice the area of the face.
Vec3 faceNormal(const Mesh& mesh, Slot f);

/// Returns the mean position of the neighbours of v.
Vec3 neighbourMean(const Mesh& mesh, Slot v);
} // namespace core
