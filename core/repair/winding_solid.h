#pragma once

#include "core/repair/arrangement.h"

#include "core/analysis/winding_number.h"

#include <span>
#include <vector>

namespace core::repair
{
/// The rule for what space counts as solid, by its winding number. With NonZero, space that is inside and space that is
/// inside out touch along a line where surfaces cross.
struct Inside
{
    int least = 1;            ///< lowest winding number of solid space; n for the intersection of n solids
    bool isEitherWay = false; ///< whether winding numbers of -1 and less count as solid, too

    static const Inside Positive; ///< winding number above 0.5
    static const Inside NonZero;  ///< winding number above 0.5 or below -0.5
};
inline constexpr Inside Inside::Positive{};
inline constexpr Inside Inside::NonZero{1, true};

/// Surfaces that count besides the one that is arranged.
struct Beside
{
    /// Parts of the arranged surface that face inwards. Space outside the solid that only these parts wind around does
    /// not count as inside out.
    TriangleSoup cavities;
    std::vector<const WindingNumber*> beyond; ///< faces missing from the arranged surface, which do not meet it
};

struct WindingSolid
{
    TriangleSoup surface;       ///< new points rounded to the lattice, equal ones merged
    double volume = 0;          ///< volume that is inside, lattice units^3, before rounding
    double insideOutVolume = 0; ///< volume that is inside out, lattice units^3, before rounding
};

/// Returns the boundary of all space that counts as solid; overlapping parts become one. `original`: the surface that
/// was arranged. If it is not closed together with the faces beyond it, the result has borders. Uses all cores.
WindingSolid windingSolidOf(const TriangleSoup& original, const Arrangement& arrangement, Inside inside,
                            const Beside& beside, const JobControl& control = {});
} // namespace core::repair
