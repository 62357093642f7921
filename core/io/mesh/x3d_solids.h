#pragma once

#include "core/io/mesh/x3d_faces.h"

namespace core::io
{
/// Returns the faces of a Cone, a Cylinder (both with 32 sides) or an Extrusion, closed and wound anticlockwise as far
/// as its caps are wanted. Empty if it is none of these. `radians`: in the unit of the file's angles. Throws FileError
/// with the node's line.
std::optional<X3dFaces> facesOfX3dSolid(const FileBytes& file, const X3dNode& node, double radians);
} // namespace core::io
