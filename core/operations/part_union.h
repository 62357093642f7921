#pragma once

#include "core/geometry/lattice.h"
#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <optional>

namespace core
{
enum class PartUnion { NotNeeded, Done, Failed };
/// Unites the parts of a mesh if they overlap or touch, so that it gets one surface without labels, as files for print
/// have it. Failed: no sound union was found; the mesh is as it was. Precondition: each part is print-ready
/// (MeshReport). `lattice`: has all points of the mesh and of the union; without it, a union as by combine(). Thread:
/// any; uses all cores. Cost: that of doPartsOverlap(), and of a union. The result of a cancelled job is not usable.
PartUnion uniteParts(TriangleMesh& mesh, const std::optional<Lattice>& lattice, const JobControl& control = {});
} // namespace core
