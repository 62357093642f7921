#pragma once

#include "ui/gizmo/gizmo_frame.h"

#include "core/parts/part_transform.h"

namespace ui
{
/// A transformation as numbers along the axes of a gizmo's frame, about its centre.
struct TransformValues
{
    core::Vec3 move = core::Vec3::Zero(); ///< mm
    core::Vec3 degrees =
        core::Vec3::Zero(); ///< turns about X, then Y, then Z, anticlockwise as seen from the axis's tip
    core::Vec3 scale = core::Vec3::Ones();
};

core::Transform transformOf(const TransformValues& values, const GizmoFrame& frame);
/// Returns the numbers of a transformation about the frame's centre; scales along other axes than the frame's are lost.
TransformValues valuesOf(const core::Transform& transform, const GizmoFrame& frame);
} // namespace ui
