#pragma once

#include "core/sculpt/deform/deform.h"
#include "core/sculpt/edit/mirror_map.h"

namespace core
{
/// Removes from the region all vertices on the mirror's negative side. Vertices on the plane stay.
void keepHalf(Region& region, const MirrorMap& mirror);

/// Selects into `whole` the vertices that a spherical brush selects on both sides of the plane: those of `half`, and
/// the images of these that are in the ball.
void selectWhole(Region& whole, const Region& half, MirrorMap& mirror, const Mesh& mesh, const Sphere& ball);

/// Selects as selectWhole() does, but instead of the ball uses the stored distance of each image (Region::carried()),
/// in mm: at most `radius`.
void selectWholeGrabbed(Region& whole, const Region& half, MirrorMap& mirror, double radius);

/// Plans the deformation of the positive side for both sides. The dab and its image act at the same time, with
/// displacements d1 and d2 and weights w1 and w2. Where they overlap they are combined into one field:
///   D = (w1 d1 + w2 d2) / max(1, w1 + w2)
/// Vertices on the plane therefore stay in it. Layer has a fixed height, so its D is only as long as the longer of the
/// two displacements. For Grab and Snake Hook the divisor is at least 1 + c min(w1, w2) / max(w1, w2), where c is the
/// weight of the image at the dab's centre: what is dragged in the plane moves as without a mirror.
/// `whole`: the selection of the dab alone, on both sides of the plane; contains every vertex of `half`. Its plans are
/// overwritten. Returns the longest displacement planned, in mm.
double planMirrored(Region& half, Region& whole, MirrorMap& mirror, const DeformInput& input);
} // namespace core
