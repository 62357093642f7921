#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// A point on the surface, found by a ray or a nearest-point query.
struct SurfaceHit
{
    Vec3 position;
    Vec3 normal; ///< outward unit normal of the face
    /// Distance from the ray's origin or from the queried point, mm.
    double distance;
    Slot face;
    Rgb color = {}; ///< colour at `position`, interpolated between the face's corners
};
} // namespace core
