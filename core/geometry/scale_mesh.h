#pragma once

#include "core/geometry/triangle_mesh.h"

namespace core
{
/// Makes the model so many times as large about the origin; each coordinate is rounded once. False: some are no numbers
/// any more.
bool scaleMesh(TriangleMesh& mesh, double factor);
} // namespace core
