#pragma once

#include "core/mesh/mesh.h"

namespace core
{
/// Returns the area-weighted normal of a vertex: an exact sum of products of lattice coordinates, so the order of the
/// faces does not matter. In squared units of the document, not normalised; zero where the star's areas cancel.
Vec3 vertexNormal(const Mesh& mesh, Slot v);

/// Returns the normal of a face; its length is twice the area.
Vec3 faceNormal(const Mesh& mesh, Slot f);

/// Returns the mean of the vertices around v.
Vec3 neighbourMean(const Mesh& mesh, Slot v);
} // namespace core
