#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// Selects the region under the brush (paper, section 3.1). If the stroke has grabbed a region, keeps it and updates
/// the candidates. Precondition: no mirror.
void selectRegion(DabContext& context);

/// Selects the part of the region on the mirror's positive side; it represents both sides (paper, section 3.5.2).
/// Returns false if the surface that the dab and its image can change is not mirror-symmetric, bit for bit.
bool selectMirroredRegion(DabContext& context);

/// Selects into `whole` the vertices that the dab alone, without its image, would select on both sides of the mirror.
/// Precondition: the region is selected.
void selectBothSides(DabContext& context, Region& whole);

/// Repeats the selection of a ray brush after the mesh under it was refined. `selected`: receives the result; may be
/// the context's region.
void selectRefined(DabContext& context, Region& selected);
} // namespace core
