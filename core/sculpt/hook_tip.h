#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// Joins the tip of a tentacle that Snake Hook draws out to another surface that it reaches, by an exact union with a
/// capsule over the gap. Joined vertex by vertex, the tip would stop at its first corner and push the rest in.
/// Precondition: the context's region is selected. Returns false if nothing is in reach, the union cannot be done, or
/// the tip is near its mirror image; nothing has changed then. Cost: the faces within six radii of the tentacle, and
/// for a union those around it.
bool joinHookTip(DabContext& context);
} // namespace core
