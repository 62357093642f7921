#pragma once

#include "ui/gizmo/gizmo_frame.h"
#include "ui/scene/orbit_camera.h"

#include "core/parts/part_transform.h"

#include <QPointF>

namespace ui
{
/// The transformation that dragging a handle of a gizmo stands for. Positions are logical pixels in the view.
class GizmoDrag
{
public:
    GizmoDrag(const OrbitCamera& camera, const GizmoFrame& frame, GizmoHandle handle, const QPointF& from);

    GizmoHandle handle() const { return m_handle; }
    /// Keeps the kind of motion, but along or about this axis of the frame; a second time: as it began.
    void lockTo(int axis);
    /// Returns the whole transformation from the beginning of the drag to this position of the pointer. `snaps`: moves
    /// by round lengths of at least some pixels, turns by 15 degrees, scales by tenths.
    core::Transform to(const QPointF& pointer, bool snaps);

private:
    core::Vec3 moved(const QPointF& pointer) const;
    core::Vec3 turnAxis() const;
    double turned(const QPointF& pointer);
    double directionOf(const QPointF& pointer) const;
    double scaled(const QPointF& pointer) const;
    double alongAxis(const QPointF& pointer, const core::Vec3& axis) const;
    core::Vec3 inPlane(const QPointF& pointer, const core::Vec3& normal) const;

    OrbitCamera m_camera;
    GizmoFrame m_frame;
    GizmoHandle m_first, m_handle;
    QPointF m_from;
    double m_lastDirection = 0, m_angle = 0; ///< radians, of a turn
};

/// Returns the least of 1, 2 and 5 times a power of ten that is at least this length; above 0.
double roundStep(double length);
} // namespace ui
