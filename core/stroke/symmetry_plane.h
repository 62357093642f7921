#pragma once

#include "core/stroke/tool.h"

namespace core
{
/// Returns the coordinate that is mirrored at the plane: 0, 1 or 2. Precondition: there is a plane.
constexpr int axisOf(Symmetry plane)
{
    return static_cast<int>(plane) - static_cast<int>(Symmetry::X);
}

/// Returns the point's mirror image. Precondition: there is a plane.
inline Vec3 mirrored(Vec3 p, Symmetry plane)
{
    p[axisOf(plane)] *= -1;
    return p;
}

/// Returns the unit normal of the plane, through the origin, about which a stroke is mirrored; zero without symmetry.
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

/// The rectangle that viewers draw for the plane of symmetry, slightly larger than the model. Units: mm.
struct SymmetryPlane
{
    Vec3 center;
    Vec3 halfX, halfY; ///< from the centre to the middle of a side; halfX x halfY points along the normal
};

/// Returns the rectangle for a model's bounding box. halfX is along the axis that cyclically follows the normal, halfY
/// along the one after it. Preconditions: symmetry is not None, and the box is not empty.
inline SymmetryPlane symmetryPlane(Symmetry symmetry, const Box& box)
{
    constexpr double margin = 0.12; // share of the model's longest side by which the rectangle extends beyond it
    const Vec3 normal = planeNormal(symmetry);
    const Vec3 x(normal.z(), normal.x(), normal.y()), y(normal.y(), normal.z(), normal.x());
    const Vec3 half = 0.5 * box.sizes() + Vec3::Constant(margin * box.sizes().maxCoeff());
    return {box.center() - normal * normal.dot(box.center()), half.dot(x) * x, half.dot(y) * y};
}
} // namespace core
