#pragma once

#include "ui/gizmo/gizmo_frame.h"
#include "ui/scene/orbit_camera.h"

#include <QColor>
#include <QPolygonF>

#include <optional>
#include <vector>

class QPainter;

namespace ui
{
/// The picture of a gizmo as seen by a camera: arrows move along an axis, squares in a plane, the disc in the middle
/// parallel to the view; arcs turn about an axis, the outer ring about the view's; boxes stretch along an axis, the
/// inner ring evenly. It has the same size in the view at any distance. Units: logical pixels. A value type.
class GizmoShape
{
public:
    static constexpr double length = 92; ///< from the centre to the tip of an axis across the view

    enum class Handles { All, WithoutScale };

    /// A frame behind the eye has no handles.
    GizmoShape(const OrbitCamera& camera, const GizmoFrame& frame, Handles handles = Handles::All);

    /// Returns the handle at a point of the view. Of several, the one drawn last.
    std::optional<GizmoHandle> handleAt(const QPointF& point) const;
    /// Draws all handles, or only `only`. `hot`: the handle under the pointer or being dragged.
    void paint(QPainter& painter, std::optional<GizmoHandle> hot, std::optional<GizmoHandle> only = {}) const;

private:
    struct Stroke
    {
        GizmoHandle handle;
        QPolygonF points;
        QColor color;
        bool isFilled;
    };

    QPointF pixel(const core::Vec3& point) const;
    void addView();
    void addRing(int axis);
    void addPlane(int axis);
    void addArrow(int axis);
    void addScale(int axis);
    void addCircle(GizmoHandle handle, double radius, bool isFilled);
    bool isEndOn(int axis) const;

    OrbitCamera m_camera;
    GizmoFrame m_frame;
    double m_mm = 0; ///< mm per pixel at the centre
    QPointF m_centre;
    std::vector<Stroke> m_strokes; ///< in the order of drawing
};
} // namespace ui
