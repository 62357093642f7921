#pragma once

#include "ui/input/hover_query.h"
#include "ui/input/pointer_mode.h"
#include "ui/input/stroke_builder.h"
#include "ui/input/view_drag.h"

#include "core/mesh/footprint.h"
#include "core/mesh/mesh_patch.h"
#include "core/mesh/surface_hit.h"
#include "core/stroke/stroke.h"

#include <QObject>

#include <deque>
#include <optional>

namespace ui
{
/// Decides whether a drag is a stroke or an orbit, pan or zoom of the view. A left press on the model begins a stroke;
/// beside the model it moves the view. A hover query finds out which, and events wait in a queue for its answer. The
/// middle and the right button always move the view, and so does Alt if InputPreferences say so. The view orbits about
/// the place of the last stroke. No widget, no OpenGL. Thread: gui.
class PointerInput : public QObject
{
    Q_OBJECT

public:
    /// The brush and the camera are not owned.
    PointerInput(const BrushSettings* brush, OrbitCamera* camera, QObject* parent = nullptr);

    void handle(const PointerEvent& event);
    void setInputPreferences(const InputPreferences& preferences);
    /// Zooms towards a pixel, whose content stays in place; `factor` < 1 zooms in.
    void zoom(double factor, const OrbitCamera::Pixel& toward);
    void pan(const OrbitCamera::Pixel& delta);
    void orbit(const OrbitCamera::Pixel& delta);
    /// Moves the centre of a two-finger gesture. Requests the surface at that pixel, so that zoom() uses its depth; no
    /// cursor is shown.
    void setGestureCenter(const OrbitCamera::Pixel& pixel);
    /// Handles that the pointer has left the view.
    void pointerLeft();
    /// Ends the present drag like a release; `how`: whether a stroke is kept or taken back.
    void finish(core::StrokeEnd how = core::StrokeEnd::Kept);
    /// Updates the modifier keys while the pointer does not move.
    void setModifiers(Qt::KeyboardModifiers modifiers);
    /// Requests the surface under the pointer again, because the mesh has changed.
    void refreshHover();
    /// Requests the footprint again, because the brush has changed.
    void brushChanged();
    /// Turns the model about the Y axis by `angle` radians in `seconds`, while the pointer stays. An open stroke gets a
    /// sample.
    void turnModel(double angle, double seconds);
    /// Handles a motion of the camera that was not made by this class.
    void viewMoved();
    /// Forgets the surface under the pointer, because there is another model.
    void clearHover();

    /// Receives the answer to hoverRequested(). Each request is answered once and in order, at any later time. `hit`:
    /// nullopt if the ray misses the model or there is none. `footprint`: vertices under the requested brush, in the
    /// mesh that is drawn now or next; null if not requested.
    void setHover(const std::optional<core::SurfaceHit>& hit,
                  const std::shared_ptr<const core::Footprint>& footprint = {});

    /// Switches a mode on, or off if it is the present mode. Add, Pick and ChoosePart end at the next press for the
    /// brush, which emits sphereRequested() (on the model or beside it), picked() or partPicked(). In Point mode,
    /// presses on the model do nothing.
    void setMode(PointerMode mode, bool on = true);
    PointerMode mode() const { return m_mode; }

    /// Returns the place that the pointer shows to the person in VR; nullopt beside the model and in other modes.
    std::optional<core::SurfaceHit> pointed() const;
    /// Returns the place of the cursor on the surface. In Add mode it is the place of the ball, in an anchored stroke
    /// the stroke's beginning. nullopt: no cursor is shown, because the pointer is outside the view or beside the
    /// model, the view is being moved or a held key makes a press move it, or the mode is Pick, ChoosePart, Point or
    /// Handles.
    std::optional<core::SurfaceHit> hover() const;
    /// Returns true if a press at the pointer would begin a stroke.
    bool wouldStroke() const;
    /// Returns the vertices that a stroke of the ray brush would affect first; null if not requested.
    std::shared_ptr<const core::Footprint> footprint() const;
    /// The ends of the line shown during a stroke, in pixels. It begins at the brush in a steady stroke, and at the
    /// place of the press in an anchored stroke; it ends at the pointer.
    struct Stabilizer
    {
        OrbitCamera::Pixel pointer, brush;
    };
    std::optional<Stabilizer> stabilizer() const;
    /// Returns the logical pixels for 1 mm at the depth of the cursor, or of the camera's pivot if there is no cursor.
    double pixelsPerMm() const;
    bool strokeOpen() const { return m_drag == Drag::Stroke; }
    /// Returns true while a press waits for its answer; it may still become a stroke.
    bool isPressPending() const { return !m_pending.empty(); }
    /// Returns the settings of the open stroke, or of a stroke that would begin now.
    core::StrokeSettings stroke() const;

Q_SIGNALS:
    /// Requests the surface along a ray; one request at a time. `brush`: its footprint is requested too; nullopt:
    /// only the surface is requested. Spherical brushes need no footprint: their region is drawn without one.
    void hoverRequested(const core::Ray& ray, const std::optional<core::StrokeSettings>& brush);
    void hoverChanged();
    /// A stroke: strokeBegan, one or more strokeSampled (the first at the press), strokeEnded; never nested. Its
    /// placement is Ray. `settings`: those at the time of the press.
    void strokeBegan(const core::StrokeSettings& settings);
    /// Emitted for every event of mouse or pen (in a steady stroke: that moves the brush), and repeatedly while an
    /// airbrush rests or the model turns.
    /// `sample.time`: seconds, on the clock of the events. `position` (mm) and `direction`: ray through the pixel, not
    /// rounded to the lattice.
    void strokeSampled(const core::StrokeSample& sample);
    void strokeEnded(core::StrokeEnd how);
    void pressDecided();
    void modeChanged(ui::PointerMode mode);
    /// The model was pressed in Pick mode; nullopt: the press was beside it.
    void picked(const std::optional<core::SurfaceHit>& hit);
    void viewChanged();
    /// The right button was clicked at this pixel.
    void paletteRequested(const ui::OrbitCamera::Pixel& pixel);
    /// The user chooses the part that the ray meets, by a click with Alt or in ChoosePart mode.
    void partPicked(const core::Ray& ray);
    /// The user has turned, moved or zoomed the view; viewChanged() follows.
    void viewMovedByUser();
    /// A ball is to be added, as one dab with the brush's radius at the sample's position.
    void sphereRequested(const core::StrokeSettings& settings, const core::StrokeSample& sample);

private:
    /// An event together with the state at the time it arrived.
    struct PendingEvent
    {
        PointerEvent event;
        core::Ray ray;
        core::StrokeSettings settings; ///< settings of the stroke; set for presses only
        double stabilizerLength = 0;   ///< pixels; set for presses only
    };

    void process(const PendingEvent& pending);
    void press(const PendingEvent& pending, const std::optional<core::SurfaceHit>& hit);
    void move(const PendingEvent& pending);
    void release(const PointerEvent& event);
    void begin(const PendingEvent& press, const std::optional<core::SurfaceHit>& hit);
    void end(core::StrokeEnd how = core::StrokeEnd::Kept);
    void processPending(const std::optional<core::SurfaceHit>& hit);
    core::StrokeSettings strokeFor(Qt::KeyboardModifiers modifiers, bool eraser) const;
    bool movesView() const;
    OrbitCamera::Pixel brushAt() const;
    bool isUndecided(const PointerEvent& event) const;
    void setTargetDepthAt(const OrbitCamera::Pixel& pixel);
    void sendQuery(const HoverQuery::Request& request);
    bool isForBrush(const PointerEvent& press) const;
    void addSphere(const PendingEvent& press, const std::optional<core::SurfaceHit>& hit);
    void moveView(const OrbitCamera::Pixel& delta);
    void emitViewMovedByUser();

    const BrushSettings* m_brush;
    OrbitCamera* m_camera;
    StrokeBuilder m_stroke;
    HoverQuery m_query;

    Drag m_drag = Drag::None;
    Qt::MouseButton m_dragButton = Qt::NoButton;
    OrbitCamera::Pixel m_pressed{0, 0};       ///< pixel at which the drag began
    std::optional<core::SurfaceHit> m_anchor; ///< surface at m_pressed, in an anchored stroke
    OrbitCamera::Pixel m_last{0, 0};
    bool m_hasMoved = false; ///< the present drag has moved farther than a click may
    bool m_inside = false;
    bool m_isGesture = false; ///< a two-finger gesture is inside the view, no pointer
    PointerMode m_mode = PointerMode::Sculpt;
    InputPreferences m_preferences;
    Qt::KeyboardModifiers m_modifiers;
    bool m_isEraser = false;            ///< the last event was from an eraser
    std::deque<PendingEvent> m_pending; ///< waiting events; the first is a press whose hit is unknown
};
} // namespace ui
