#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// Joins the tip of a tentacle, drawn out by Snake Hook, to another surface or to its mirror image within reach, by an
/// exact union with a solid that bridges the gap. Joining it vertex by vertex (fuse/) would stop at the first corner
/// that touches and push the other surface in. Precondition: the context's region is selected. Returns false, with the
/// surface as it was, if nothing is in reach or the union fails. Cost: the faces within six radii of the tentacle,
/// plus, for a union, the faces around it.
bool joinHookTip(DabContext& context);
} // namespace core
