#pragma once

#include "core/repair/arrangement.h"

namespace core::repair
{
/// The rule for what space counts as solid, by its winding number. With NonZero, space that is inside and space that is
/// inside out touch along a line where surfaces cross.
enum class Inside {
    Positive, ///< winding number above 0.5
    NonZero   ///< winding number above 0.5 or below -0.5
};

struct WindingSolid
{
    TriangleSoup surface;       ///< new points rounded to the lattice, equal ones merged
    double volume = 0;          ///< volume that is inside, lattice units^3, before rounding
    double insideOutVolume = 0; ///< volume that is inside out, lattice units^3, before rounding
};

/// Returns the boundary of all space that counts as solid; overlapping parts become one. `original`: the surface that
/// was arranged; if it is not closed, the result has borders. `cavities`: parts of it that face inwards; space outside
/// the solid that only these wind around does not count as inside out. Uses all cores.
WindingSolid windingSolidOf(const TriangleSoup& original, const Arrangement& arrangement, Inside inside,
                            const TriangleSoup& cavities, const JobControl& control = {});
} // namespace core::repair
