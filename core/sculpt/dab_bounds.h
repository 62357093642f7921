#pragma once

#include "core/mesh/mesh.h"
#include "core/stroke/stroke.h"

namespace core
{
/// Returns the tool's d as a share of the brush's d. Less than 1 for tools that need a finer mesh than the brush, such
/// as Crease.
double detailShare(const StrokeSettings& settings);

/// Returns the edge bounds to which a dab of this radius remeshes (paper, section 3.2.2).
EdgeBounds dabBounds(const StrokeSettings& settings, const Mesh& mesh, double radius);
} // namespace core
