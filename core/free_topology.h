#pragma once

#include "judged_mesh.h"
#include "mirror_map.h"
#include "stroke.h"

namespace core
{
/// Why spheres of that radius may not be added at these places together, if so; what stands there twice is one.
Refusal refusalOf(const JudgedMesh& surface, const std::vector<Vec3>& centers, double radius);

/// Free topology (paper, section 3.5.1): adds a sphere to the surface if it lies outside the model, clear of it and inside
/// the working volume. With a mirror (or none: null) its image is added too, or neither is; a sphere whose centre is on the
/// plane is its own image, another must be clear of its image. A refused one changes nothing. Precondition: a stroke is open.
DabReport addSphere(JudgedMesh& surface, const Sphere& ball, const MirrorMap* mirror);
} // namespace core
