#pragma once

#include "core/sculpt/dab_context.h"
#include "core/sculpt/solid_boolean.h"

namespace core
{
/// The outcome of a boolean dab. Apart: the surfaces do not meet. Apart and Failed leave everything as it was.
enum class BooleanOutcome { Done, Apart, Failed };

/// Unites the model with a solid, or subtracts the solid from it, as one step, and makes the mesh there quasi-uniform;
/// the curves in which the surfaces met stay sharp. With a mirror the solid's image, too, where the two are changing
/// different faces, else it fails; where it would take masked faces away it fails, too. Counts as one fusion. The
/// context's region becomes what was changed. `points`: where the solid's points are to be, in mm, within the working
/// volume.
BooleanOutcome applyBoolean(DabContext& context, TriangleMesh solid, const std::vector<Vec3>& points,
                            BooleanOperation operation);
} // namespace core
