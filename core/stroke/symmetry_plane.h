#pragma once

#include "core/stroke/tool.h"

namespace core
{
/// The unit normal of the plane about which a stroke is mirrored, which goes through the origin; zero without symmetry.
inline Vec3 planeNormal(Symmetry symmetry)
{
    switch (symmetry) {
    case Symmetry::None:
        return Vec3::Zero();
    case Symmetry::X:
        return Vec3::UnitX();
    case Symmetry::Y:
        return Vec3::UnitY();
    case Symmetry::Z:
        return Vec3::UnitZ();
    }
    return Vec3::Zero();
}

/// How viewers show that plane: a pane through the model, a little larger than it. mm.
struct SymmetryPlane
{
    Vec3 center;
    Vec3 halfX, halfY; ///< from the centre to the middle of a side; halfX x halfY points along the normal
};

/// There is a symmetry, and the box is not empty. X lies along the next axis after the normal, Y along the one after
/// that.
inline SymmetryPlane symmetryPlane(Symmetry symmetry, const Box& box)
{
    constexpr double margin = 0.12; // of the model's longest side
    const Vec3 normal = planeNormal(symmetry);
    const Vec3 x(normal.z(), normal.x(), normal.y()), y(normal.y(), normal.z(), normal.x());
    const Vec3 half = 0.5 * box.sizes() + Vec3::Constant(margin * box.sizes().maxCoeff());
    return {box.center() - normal * normal.dot(box.center()), half.dot(x) * x, half.dot(y) * y};
}
} // namespace core
