#pragma once

#include "judged_mesh.h"
#include "mirror_map.h"
#include "stroke.h"

namespace core
{
/// Why a sphere may not be added there, if so.
Refusal refusalOf(const JudgedMesh& surface, const Sphere& ball);

/// Free topology (paper, section 3.5.1): adds a sphere to the surface if it lies outside the model, clear of it and inside
/// the working volume. With a mirror (or none: null) its image is added too, or neither is; a sphere whose centre is on the
/// plane is its own image, another must be clear of its image. A refused one changes nothing. Precondition: a stroke is open.
DabReport addSphere(JudgedMesh& surface, const Sphere& ball, const MirrorMap* mirror);
} // namespace core
