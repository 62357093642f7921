#pragma once

#include "core/geometry/triangle_mesh.h"

namespace core
{
/// Scales the model about the origin; each coordinate is rounded once. Returns false if a coordinate has become
/// infinite or NaN.
bool scaleMesh(TriangleMesh& mesh, double factor);
} // namespace core
