#pragma once

#include "judged_mesh.h"
#include "stroke.h"

namespace core
{
/// Free topology (paper, section 3.5.1): adds a sphere to the surface if it lies outside the model, clear of it and inside
/// the working volume. A refused one changes nothing. Precondition: a stroke is open.
DabReport addSphere(JudgedMesh& surface, const Sphere& ball);
} // namespace core
