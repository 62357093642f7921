#pragma once

#include "core/io/mesh/x3d_faces.h"

namespace core::io
{
/// Returns the faces of a Cone, a Cylinder (both with 32 sides) or an Extrusion, closed and wound anticlockwise as far
/// as its caps are wanted. Empty if it is none of these. Throws FileError with its line.
std::optional<X3dFaces> facesOfX3dSolid(const FileBytes& file, const X3dNode& node);
} // namespace core::io
