#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// Lets the tip of what Snake Hook draws out become part of another surface that it reaches, by an exact union with a
/// capsule over the gap. Vertex by vertex the tip would join at the first corner that meets, and push the rest in.
/// `context`: its region is selected. Returns false if there is nothing in reach, or the union cannot be done, or the
/// tip is near its mirror image; then nothing has changed. Cost: the faces within four radii of what was drawn out; of
/// a union those around it.
bool joinHookTip(DabContext& context);
} // namespace core
