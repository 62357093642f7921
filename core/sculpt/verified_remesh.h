#pragma once

#include "core/sculpt/dab_context.h"

#include <functional>

namespace core
{
/// Runs `remesh` as one transaction and adds its counts to the context. Returns false, with nothing changed, if the
/// result does not verify.
bool remeshVerified(DabContext& context, const std::function<RemeshCounts()>& remesh);

/// Returns an editor that verifies each operation by itself. Once the dab has spent its work budget (WorkBudget), the
/// editor refuses all further operations.
MeshEditor verifiedEditor(DabContext& context);

/// Splits the region's edges that are longer than d_detail, and verifies each split by itself. To be used if optimising
/// the region as a whole does not verify.
void splitVerified(DabContext& context);
} // namespace core
