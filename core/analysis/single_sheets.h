#pragma once

#include "core/geometry/triangle_mesh.h"

namespace core
{
/// Returns the faces of a mesh with each sheet once. Sheets coincide where they are nearly parallel and within `nearby`
/// of each other. Where more of them face one way than the other, one that faces this way is kept. Where as many face
/// either way, none is kept: solids touch there. A face that is left out in part only is cut into 256 pieces, so the
/// result may have borders. It serves winding numbers: those of the mesh count a body twice that is there twice. Uses
/// all cores. Cost: one sort, and about 1 us per face, 20 us per face longer than 1/50 of the size.
TriangleMesh singleSheets(const TriangleMesh& mesh, double nearby);
} // namespace core
