#pragma once

#include "core/mesh/surface_hit.h"
#include "core/operations/model_command.h"

#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QAction;
class QKeyEvent;
class QSinglePointEvent;

namespace ui
{
class BrushSettings;
class ViewHint;
class Viewport;

/// A tool that draws over the view and gets its events first, while its action is checked. Events that it does not
/// consume move the view (PointerMode::Handles); Esc, or another mode, ends it. Drawn over its parent and transparent
/// for the mouse. Thread: gui.
class ViewTool : public QWidget
{
    Q_OBJECT

public:
    /// The viewport is the parent. `brush`: has the symmetry and the radius.
    ViewTool(QAction* action, const BrushSettings* brush, Viewport* viewport, const char* name);

    /// Places where rays meet the model, in their order; nullopt: a ray misses it.
    using Hits = std::vector<std::optional<core::SurfaceHit>>;
    using Answer = std::function<void(const Hits& hits)>;

    /// The request that was emitted last has ended. `isMade`: the model has been changed.
    void endRequest(bool isMade);

Q_SIGNALS:
    /// Asks where rays meet the model. `answer` may be called at any later time, also when the tool does not exist any
    /// more.
    void surfaceWanted(const std::vector<core::Ray>& rays, const ui::ViewTool::Answer& answer);
    void requested(const core::ModelCommand& command);

protected:
    /// The tool is switched on or off: forgets what it has shown.
    virtual void clear() = 0;
    /// Shows the present state.
    virtual void refresh() = 0;
    /// Calls refresh() when the events that have come are handled: a mouse can send more of them than can be shown.
    void refreshSoon() { m_refresh.start(); }
    /// Handle an event, and return whether it is consumed.
    virtual bool handlePointer(const QSinglePointEvent& event) = 0;
    virtual bool handleKey(const QKeyEvent& event) = 0;
    /// Takes the answer to ask().
    virtual void place(const std::vector<core::Ray>& rays, const Hits& hits) = 0;
    /// Returns whether a button is held, so that the view must not move.
    virtual bool isHeld() const = 0;

    Viewport* viewport() const { return m_viewport; }
    const BrushSettings* brush() const { return m_brush; }
    ViewHint* hint() const { return m_hint; }
    /// The plane at which the user mirrors what is drawn.
    core::Symmetry symmetry() const;
    /// Returns whether a place is seen so near to the plane of symmetry that it is meant to be on it.
    bool isAtPlane(const core::Vec3& place) const;
    /// Shows a solid, and its mirror image, translucent; an empty one: shows none.
    void showTranslucent(core::TriangleMesh solid);
    /// Asks where the rays meet the model. Until place() is called, isAsking().
    void ask(const std::vector<core::Ray>& rays);
    bool isAsking() const { return m_isAsking; }
    /// Requests a change of the model. The tool ends when it is made.
    void request(const core::ModelCommand& command);
    void end();

    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void setOn(bool on);
    void followCamera();

    QAction* m_action;
    const BrushSettings* m_brush;
    Viewport* m_viewport;
    ViewHint* m_hint;
    QTimer m_refresh;
    int m_question = 0; ///< number of the last question; an answer to an earlier one is ignored
    bool m_isAsking = false, m_isRequested = false;
    Eigen::Matrix4d m_view = Eigen::Matrix4d::Zero(); ///< camera's matrices when the tool was drawn
};
} // namespace ui
