#pragma once

#include "core/geometry/geometry.h"

namespace ui
{
/// The place and the axes of a gizmo. Space: document, mm.
struct GizmoFrame
{
    core::Vec3 centre = core::Vec3::Zero();
    Eigen::Quaterniond axes = Eigen::Quaterniond::Identity(); ///< unit length

    /// Returns the direction of an axis, 0 to 2, unit length.
    core::Vec3 axis(int index) const { return axes * core::Vec3::Unit(index); }
};

/// A handle of a gizmo. Planes are named by their two axes.
enum class GizmoHandle {
    MoveX,
    MoveY,
    MoveZ,
    MoveYZ,
    MoveZX,
    MoveXY,
    MoveView, ///< parallel to the view
    TurnX,
    TurnY,
    TurnZ,
    TurnView, ///< about the direction of the view
    ScaleX,
    ScaleY,
    ScaleZ,
    ScaleAll
};
enum class GizmoMotion { Move, MoveInPlane, Turn, Scale };

constexpr GizmoMotion motionOf(GizmoHandle handle)
{
    if (handle <= GizmoHandle::MoveZ)
        return GizmoMotion::Move;
    if (handle <= GizmoHandle::MoveView)
        return GizmoMotion::MoveInPlane;
    return handle <= GizmoHandle::TurnView ? GizmoMotion::Turn : GizmoMotion::Scale;
}

/// Returns the axis of a handle, 0 to 2, of a plane its normal; -1 if it has none.
constexpr int axisOf(GizmoHandle handle)
{
    switch (handle) {
    case GizmoHandle::MoveView:
    case GizmoHandle::TurnView:
    case GizmoHandle::ScaleAll:
        return -1;
    default:
        break;
    }
    const GizmoHandle firsts[] = {GizmoHandle::ScaleX, GizmoHandle::TurnX, GizmoHandle::MoveYZ, GizmoHandle::MoveX};
    for (const GizmoHandle first : firsts) {
        if (handle >= first)
            return static_cast<int>(handle) - static_cast<int>(first);
    }
    return -1;
}
} // namespace ui
