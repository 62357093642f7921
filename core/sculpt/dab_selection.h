#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// Selects the region under the brush (paper, section 3.1), or goes on with what the stroke has grabbed. Precondition:
/// no mirror.
void selectRegion(DabContext& context);

/// Selects, in the half of the context's mirror, the region that stands for both sides (paper, section 3.5.2). False if
/// the surface that the dab and its image can change is not symmetric, bit for bit.
bool selectMirroredRegion(DabContext& context);

/// Selects what a mirrored dab alone would select, on both sides: `whole`. Precondition: the region is selected.
void selectBothSides(DabContext& context, Region& whole);

/// Selects again what a brush along the surface finds after the mesh under it was refined. `selected`: the region
/// itself, or another.
void selectRefined(DabContext& context, Region& selected);
} // namespace core
