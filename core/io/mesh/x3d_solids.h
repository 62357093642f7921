#pragma once

#include "core/io/mesh/x3d_faces.h"

namespace core::io
{
/// Returns the faces of a Cone, a Cylinder (both with 32 sides) or an Extrusion, oriented anticlockwise. They are
/// closed if the node's caps are not switched off. Empty for another node. `radians`: the file's unit of angles in
/// radians. Throws FileError with the node's line.
std::optional<X3dFaces> facesOfX3dSolid(const FileBytes& file, const X3dNode& node, double radians);
} // namespace core::io
