#pragma once

#include "core/mesh/mesh.h"
#include "core/stroke/stroke.h"

namespace core
{
/// Returns the tool's own d in terms of the brush's: less than 1 where a tool makes the mesh finer for what it shapes.
double detailShare(const StrokeSettings& settings);

/// Returns the edge lengths to which a dab of that radius remeshes (paper, section 3.2.2).
EdgeBounds dabBounds(const StrokeSettings& settings, const Mesh& mesh, double radius);
} // namespace core
