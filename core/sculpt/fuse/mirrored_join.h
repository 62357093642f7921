#pragma once

#include "core/sculpt/edit/mirror_map.h"

#include <optional>

namespace core
{
// Surgeries next to a mirror plane. Each function makes the surgery for the positive side (plane included); withImage()
// adds the other side.

/// Joins a vertex on the positive side with its own image. Both stars are removed, and each 1-ring is connected to its
/// projection on the plane, a ring of new vertices. A 1-ring with vertices on the plane is connected arc by arc.
/// Returns nothing if the two stars are their whole component. Precondition: v is not on the plane.
std::optional<Surgery> joinAcross(const Mesh& mesh, const MirrorMap& mirror, Slot v);

/// Joins two vertices on the plane. The positive half of each star is removed, and the half rings are connected as
/// joinStars() connects whole rings. Returns nothing if the half rings share a vertex.
std::optional<Surgery> joinOnPlane(const Mesh& mesh, const MirrorMap& mirror, Slot p, Slot q);

/// Returns the surgery and its mirror image combined into one. A new vertex on the plane is its own image. Returns
/// nothing if a face has no image, if a copy of a vertex on the plane leaves the plane, if a new vertex is beyond the
/// plane, or if the result would not be a closed 2-manifold. Precondition: MirrorMap::learn() was called for the faces
/// to be removed.
std::optional<Surgery> withImage(const Mesh& mesh, MirrorMap& mirror, const Surgery& half);
} // namespace core
