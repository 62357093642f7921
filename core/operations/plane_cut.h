#pragma once

#include "core/operations/model_command.h"

namespace core
{
/// Ways in which a plane and its mirror image make a cut with symmetry.
enum class MirroredPlane {
    None,  ///< there is no symmetry
    Other, ///< the image is another plane: what is beyond either goes
    Same,  ///< the image is the plane itself, facing the same way: the plane contains the mirror normal's direction
    Turned ///< the plane is the plane of symmetry: one cut is made, and one half goes
};
/// Returns how the plane meets its mirror image. Deviations by less than a hundred-thousandth of the box's diagonal do
/// not count. Preconditions as below.
MirroredPlane mirroredPlane(const Vec3& point, const Vec3& normal, const Box& box, Symmetry symmetry);

/// Returns the command that cuts away everything on the positive side of a plane and, with symmetry, of its mirror
/// image; see MirroredPlane. The cut is flat to a few lattice units, because its points are rounded one by one.
/// Precondition: `normal` is not zero, of any length; `box` contains the model and is not empty.
Trim trimBeyond(const Vec3& point, const Vec3& normal, const Box& box, Symmetry symmetry = Symmetry::None);
} // namespace core
