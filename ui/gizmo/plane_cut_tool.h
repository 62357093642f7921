#pragma once

#include "ui/gizmo/gizmo_frame.h"

#include "core/operations/model_command.h"
#include "core/operations/plane_cut.h"
#include "core/operations/transform_region.h"

#include <QObject>

#include <optional>

class QAction;
class QCheckBox;
class QLabel;

namespace ui
{
class Actions;
class BrushSettings;
class Gizmo;
class ViewCard;
class Viewport;

/// Cuts the active part along a plane that handles place in the view, and with symmetry along its mirror image, too.
/// The clay that goes is tinted. Switched by the action "area.plane". Knows no document: it asks for the part's box by
/// a signal, and requests cuts. Thread: gui.
class PlaneCutTool : public QObject
{
    Q_OBJECT

public:
    /// The viewport is the parent. `brush` has the symmetry.
    PlaneCutTool(const Actions& actions, const BrushSettings* brush, Viewport* viewport);

    bool isOn() const;
    /// Answers regionWanted(), or says that the part has changed.
    void setRegion(const core::TransformRegion& region);

    /// While a long job runs, nothing can be cut.
    void setBusy(bool isBusy);

public Q_SLOTS:
    /// Asks for the region if the tool is on, because the part may have changed.
    void refresh();

Q_SIGNALS:
    void regionWanted();
    void requested(const core::ModelCommand& command);

private:
    ViewCard* makeBar();
    QString wordFor(core::MirroredPlane image) const;
    void setOn(bool on);
    void showPlane();
    void swapSides();
    void request(bool splits);

    Viewport* m_viewport;
    const BrushSettings* m_brush;
    QAction* m_action;
    Gizmo* m_gizmo;
    QLabel* m_word; ///< what symmetry does; hidden without it
    QCheckBox* m_colors;
    ViewCard* m_bar;
    std::optional<core::Box> m_box;                    ///< of the part; nullopt: not known yet
    std::shared_ptr<const core::Footprint> m_vertices; ///< of the part
};
} // namespace ui
