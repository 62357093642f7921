#pragma once

#include "core/area/view_area.h"
#include "core/geometry/triangle_mesh.h"

namespace core
{
class Mesh;

/// The solid that a curve in the view sweeps through a model.
struct SweptOutline
{
    bool hasArea = false; ///< false: the curve has no area or is too tangled, or a corner is beside or behind the eye
    /// Closed and oriented outwards; it may have several shells. It begins just in front of the model and ends just
    /// behind it, and is clipped where it would go far beside it. Its walls have edges about as long as the model's.
    /// Empty if the curve does not go around any point of the model's box as seen from the eye.
    TriangleMesh solid;
};

/// Returns the solid that the area's curve sweeps, without its mirror image. Cost: the mesh's vertices, and quadratic
/// in the corners. Thread: any.
SweptOutline sweptOutline(const ViewArea& area, const Mesh& mesh);
} // namespace core
