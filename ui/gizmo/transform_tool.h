#pragma once

#include "ui/gizmo/gizmo_frame.h"

#include "core/operations/model_command.h"
#include "core/operations/transform_region.h"

#include <QObject>

#include <optional>

class QAction;

namespace ui
{
class Actions;
class Gizmo;
class TransformFields;
class Viewport;

/// Moves, turns and scales the active part, or what of it is not masked, by handles in the view or by numbers. The
/// viewport shows the change before it is made. Switched by the action "model.transform". Knows no document: it asks
/// for the region by a signal, and requests changes. Thread: gui.
class TransformTool : public QObject
{
    Q_OBJECT

public:
    /// The viewport is the parent.
    TransformTool(const Actions& actions, Viewport* viewport);

    bool isOn() const;
    /// Answers regionWanted(), or says that the part has changed. Ends the preview.
    void setRegion(const core::TransformRegion& region);

    /// While a long job runs, nothing can be changed.
    void setBusy(bool isBusy);

public Q_SLOTS:
    /// Asks for the region if the tool is on, because the part, its mask or its shape may have changed.
    void refresh();
    /// Ends the preview of a requested change that was not made.
    void dropRequest();

Q_SIGNALS:
    void regionWanted();
    void requested(const core::ModelCommand& command);

private:
    void setOn(bool on);
    void showFrame();
    void preview(const core::Transform& by);
    void request(const core::Transform& by);

    Viewport* m_viewport;
    QAction* m_action;
    Gizmo* m_gizmo;
    TransformFields* m_fields;
    std::optional<core::TransformRegion> m_region;
    GizmoFrame m_start; ///< frame that the drag, or the numbers, refer to
    /// Middle of the region for which the frame's centre is kept, because the user has moved it, or the part by it
    std::optional<core::Vec3> m_keptFor;
    bool m_hasTurnedAxes = false; ///< the user has turned the frame alone
    bool m_isRequested = false;   ///< the next region follows from the change that was requested
};
} // namespace ui
