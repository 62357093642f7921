#pragma once

#include "core/repair/arrangement.h"

namespace core::repair
{
/// What counts as solid, by how often the surface winds around it. Where surfaces cross, the space that is inside and
/// the space that is inside out touch along a line.
enum class Inside {
    Positive, ///< more than a half: no such touches
    NonZero   ///< more than a half either way
};

struct WindingSolid
{
    TriangleSoup surface;       ///< new points rounded to the lattice; equal ones are one
    double volume = 0;          ///< lattice units^3, of what is inside, before rounding
    double insideOutVolume = 0; ///< lattice units^3, of what is inside out, before rounding
};

/// The boundary of all that counts as solid: what is inside of two parts is inside. `original` is the surface that was
/// arranged. It should be closed; where it is not, the outcome has borders. `cavities`: parts of it that face inwards;
/// space that they alone wind around outside of the solid does not count as inside out. All cores.
WindingSolid windingSolidOf(const TriangleSoup& original, const Arrangement& arrangement, Inside inside,
                            const TriangleSoup& cavities, const JobControl& control = {});
} // namespace core::repair
