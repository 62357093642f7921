#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

namespace core
{
/// Returns whether parts of the mesh overlap, touch, or are inside the material of others, so that all parts together
/// do not bound a solid. Precondition: each part is print-ready (MeshReport). Cost: O(mesh) if the boxes of the parts
/// are apart, else that of checkMesh(). The result is not usable if the job was cancelled.
bool doPartsOverlap(const TriangleMesh& mesh, const JobControl& control = {});
} // namespace core
