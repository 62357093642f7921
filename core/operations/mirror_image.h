#pragma once

#include "core/operations/model_command.h"
#include "core/stroke/symmetry_plane.h"

namespace core
{
/// Returns the surface mirrored at the plane through the origin, facing outwards.
TriangleMesh mirrorImage(TriangleMesh surface, Symmetry plane);
Box mirrorImage(const Box& box, Symmetry plane);
/// Returns the surface and its mirror image in one mesh, which crosses itself where they meet. Without a plane, returns
/// the surface.
TriangleMesh besideImage(TriangleMesh surface, Symmetry plane);

/// Moves a place onto the plane, and turns a direction into it or, if it almost is at a right angle to it, to that.
void putOnPlane(Vec3& place, Vec3& direction, Symmetry plane);

/// Returns the union of a solid and its mirror image, symmetric bit for bit, on the lattice. If the solid is its
/// own image but for its triangles, that is one half and its image. Masks are dropped. Returns nothing, and sets
/// `change` unless the job was cancelled, if there is no sound one. Precondition: the solid is print-ready, and the
/// lattice contains both. Cost: a boolean (mesh_boolean.h) if both overlap.
std::optional<TriangleMesh> withMirrorImage(TriangleMesh solid, const Lattice& lattice, Symmetry plane,
                                            ModelChange& change, const JobControl& control);

/// Replaces the half of the mesh that allows it by the image of the other (symmetrize.h). Vertices at places where
/// there were some keep their colours and masks, and stay hidden. Returns false if neither half allows it or the job
/// was cancelled. Precondition: a stroke of the mesh is open.
bool mirrorHalf(Mesh& mesh, Symmetry plane, const JobControl& control);
} // namespace core
