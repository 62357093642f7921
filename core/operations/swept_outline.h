#pragma once

#include "core/operations/model_command.h"

namespace core
{
/// The solid that a Trim's curve sweeps through a model.
struct SweptOutline
{
    bool hasArea = false; ///< false: the curve has no area or is too tangled, or a corner is beside or behind the eye
    /// Closed and oriented outwards; it may have several shells. It begins just in front of the model and ends just
    /// behind it, and is clipped where it would go far beside it. Its walls have edges about as long as the model's.
    /// Empty if the curve does not go around any point of the model's box as seen from the eye.
    TriangleMesh solid;
};

/// Returns the solid that the curve sweeps. Cost: the mesh's vertices, and quadratic in the corners. Thread: any.
SweptOutline sweptOutline(const Trim& command, const Mesh& mesh);
} // namespace core
