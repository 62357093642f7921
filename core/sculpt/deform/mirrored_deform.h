#pragma once

#include "core/sculpt/deform/deform.h"
#include "core/sculpt/edit/mirror_map.h"

namespace core
{
/// Removes the vertices from the region that do not lie in the mirror's half, its plane included.
void keepHalf(Region& region, const MirrorMap& mirror);

/// Selects what a spherical brush selects on both sides of the plane: the half, and those of its images that lie in the
/// ball.
void selectWhole(Region& whole, const Region& half, MirrorMap& mirror, const Mesh& mesh, const Sphere& ball);

/// Selects as selectWhole() does, but by the distance that each vertex carries for its image, in mm.
void selectWholeGrabbed(Region& whole, const Region& half, MirrorMap& mirror, double radius);

/// Plans the deformation of a half that stands for both sides. The dab and its image are two dabs of one moment, d1 and
/// d2 with the weights w1 and w2; where they overlap they are one field,
///   D = (w1 d1 + w2 d2) / max(1, w1 + w2)
/// so that on the plane nothing moves off it. Layer has one height: its D is only as long as the longer of the two.
/// `whole`: the selection of the dab alone, on both sides of the plane; every vertex of the half belongs to it. Its
/// plans are overwritten. Returns the longest displacement planned, in mm.
double planMirrored(Region& half, Region& whole, MirrorMap& mirror, const DeformInput& input);
} // namespace core
