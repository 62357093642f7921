#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// A point of the surface.
struct SurfaceHit
{
    Vec3 position;
    Vec3 normal;     ///< of the face, unit length, outwards
    double distance; ///< from the ray's origin, or from the point asked about
    Slot face;
    Rgb color = {}; ///< there, between those of the face's corners
};
} // namespace core
