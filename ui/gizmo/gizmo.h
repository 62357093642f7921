#pragma once

#include "ui/gizmo/gizmo_drag.h"
#include "ui/gizmo/gizmo_shape.h"

#include "core/stroke/tool.h"

#include <QWidget>

#include <optional>

class QKeyEvent;
class QSinglePointEvent;

namespace ui
{
class Viewport;

/// Handles over the view that move, turn and scale what its owner shows. While it has a frame, presses beside the
/// handles move the view (PointerMode::Handles); Esc, or another mode, ends it. During a drag, Ctrl snaps to round
/// values, X, Y and Z keep to an axis, and Esc or the right button takes the drag back. A drag that begins with Alt
/// moves the frame alone. Drawn over its parent and transparent for the mouse. Thread: gui.
class Gizmo : public QWidget
{
    Q_OBJECT

public:
    explicit Gizmo(Viewport* viewport, GizmoShape::Handles handles = GizmoShape::Handles::All);

    /// Shows the handles at this frame; nullopt: ends the gizmo. During a drag, the frame is set when the drag ends.
    void setFrame(const std::optional<GizmoFrame>& frame);
    const std::optional<GizmoFrame>& frame() const { return m_frame; }
    /// Shows a square across the frame's second axis, of this half side, mm; 0: none.
    void setPlane(double halfSide) { m_plane = halfSide; }
    /// Shows the square's mirror image about this plane of symmetry as well, more faintly; None: does not.
    void setImage(core::Symmetry image) { m_image = image; }
    bool isDragging() const { return m_drag.has_value(); }
    /// Ends a drag without effect.
    void cancelDrag();

Q_SIGNALS:
    /// A handle is being dragged. `by`: the whole transformation since its press.
    void dragged(const core::Transform& by);
    /// The drag has ended; `by`: no change if it was taken back. The frame has moved with it.
    void dropped(const core::Transform& by);
    /// The user has moved the frame alone.
    void frameMoved();
    /// The user has ended the gizmo, which has no frame any more.
    void ended();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    bool handlePointer(const QSinglePointEvent& event);
    bool handleKey(const QKeyEvent& event);
    bool press(const QSinglePointEvent& event);
    void moveTo(const QPointF& pointer, Qt::KeyboardModifiers modifiers);
    void drop();
    void followMode();
    void setHot(std::optional<GizmoHandle> handle);
    GizmoShape shape() const;
    void paintPlane(QPainter& painter, core::Symmetry image) const;
    void followCamera();

    Viewport* m_viewport;
    GizmoShape::Handles m_handles;
    double m_plane = 0; ///< half side of the square, mm
    core::Symmetry m_image = core::Symmetry::None;
    std::optional<GizmoFrame> m_frame;
    std::optional<GizmoHandle> m_hot; ///< handle under the pointer
    std::optional<GizmoDrag> m_drag;
    core::Transform m_by; ///< transformation of the drag so far
    GizmoFrame m_start;   ///< frame when the drag began
    QPointF m_pointer;
    Eigen::Matrix4d m_view = Eigen::Matrix4d::Zero(); ///< camera's matrices when the handles were drawn
    bool m_movesFrameOnly = false;
    bool m_releaseFollows = false; ///< the release of the press of a cancelled drag is still to come
};

/// Returns the frame after a transformation about it.
GizmoFrame moved(const GizmoFrame& frame, const core::Transform& by);
} // namespace ui
