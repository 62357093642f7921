#pragma once

#include "core/sculpt/dab_context.h"

#include <functional>

namespace core
{
/// Remeshes in a transaction of its own, and counts what it has done. Returns whether it verified; if it did not,
/// nothing has changed.
bool remeshVerified(DabContext& context, const std::function<RemeshCounts()>& remesh);

/// Returns an editor that verifies each operation, until the dab has done all the work that it may: then it refuses
/// them.
MeshEditor verifiedEditor(DabContext& context);

/// Splits the region's edges that are longer than d_detail, where each split verifies by itself: for where an
/// optimisation does not.
void splitVerified(DabContext& context);
} // namespace core
