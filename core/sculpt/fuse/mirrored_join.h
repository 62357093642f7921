#pragma once

#include "core/sculpt/edit/mirror_map.h"

#include <optional>

namespace core
{
// Surgery in a mirror: each of these makes the exchange for the half, the plane included; withImage() completes it.

/// Joins a vertex of the half with its own image: both stars go, and each 1-ring is connected to its projection on the
/// plane, a ring of new vertices there. Where the 1-ring has vertices on the plane it is connected arc by arc. Nothing
/// if the two stars are all there is of their component. Precondition: v is not on the plane.
std::optional<Surgery> joinAcross(const Mesh& mesh, const MirrorMap& mirror, Slot v);

/// Joins two vertices on the plane: the half of each star goes, and the half rings are connected as joinStars()
/// connects whole ones. Nothing if they have a vertex in common.
std::optional<Surgery> joinOnPlane(const Mesh& mesh, const MirrorMap& mirror, Slot p, Slot q);

/// The exchange together with its image, as one. New vertices on the plane are their own image; one that leaves it, or
/// comes to it or beyond, has none. Nothing if there is no image, or if the result would not be a closed 2-manifold.
/// Precondition: the mirror has learnt the faces that go.
std::optional<Surgery> withImage(const Mesh& mesh, MirrorMap& mirror, const Surgery& half);
} // namespace core
