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
/// Decides what a drag is: a stroke, or a turn, a move or a zoom of the view. A left press is a stroke if it is on the
/// model, else it turns the view; a hover query tells, and events that come before its answer wait in a queue. The
/// other buttons, and any with Alt, move the view wherever they are pressed. The view turns about the place of the last
/// stroke. No widget, no OpenGL. Thread: gui.
class PointerInput : public QObject
{
    Q_OBJECT

public:
    /// Takes the brush and the camera, which it does not own.
    PointerInput(const BrushSettings* brush, OrbitCamera* camera, QObject* parent = nullptr);

    void handle(const PointerEvent& event);
    void setInputPreferences(const InputPreferences& preferences);
    /// `factor` < 1 comes nearer; what lies under the pixel stays there.
    void zoom(double factor, const OrbitCamera::Pixel& toward);
    void pan(const OrbitCamera::Pixel& delta);
    void orbit(const OrbitCamera::Pixel& delta);
    /// Two fingers move the view about that pixel: requests the surface there, so that zoom() uses its depth, without
    /// showing a cursor.
    void setGestureCenter(const OrbitCamera::Pixel& pixel);
    /// The pointer left the view.
    void pointerLeft();
    /// Ends whatever drag is going on, as a release would, except that a stroke may be taken back.
    void finish(core::StrokeEnd how = core::StrokeEnd::Kept);
    /// The keys changed while the pointer rests.
    void setModifiers(Qt::KeyboardModifiers modifiers);
    /// The surface changed under the pointer.
    void refreshHover();
    /// The brush under the pointer takes something else.
    void brushChanged();
    /// The model turns under the hand, about the Y axis, by so many radians in so many seconds. An open stroke is
    /// sampled anew.
    void turnModel(double angle, double seconds);
    /// The camera was moved by somebody else.
    void viewMoved();
    /// Forgets what is under the pointer: there is another model.
    void clearHover();

    /// Takes the answer to hoverRequested(). Each is answered once, in order, at any later time: with the surface's
    /// point, or with nothing if the ray misses or there is no model. `footprint`: of the brush that was asked about;
    /// it belongs to the mesh as it is drawn, or soon will be.
    void setHover(const std::optional<core::SurfaceHit>& hit,
                  const std::shared_ptr<const core::Footprint>& footprint = {});

    /// Add and Pick end with the next press for the brush: by sphereRequested(), wherever it is, and by picked(). While
    /// Point is on, a press on the model does nothing.
    /// Off: sculpts again if that mode was on.
    void setMode(PointerMode mode, bool on = true);
    PointerMode mode() const { return m_mode; }

    /// Returns the place that the pointer shows to others; nothing beside the model and in other modes.
    std::optional<core::SurfaceHit> pointed() const;
    /// Returns the place of the cursor: the newest answer, unless the pointer left or turns the view; if armed, the
    /// place of the sphere; in an anchored stroke its beginning.
    std::optional<core::SurfaceHit> hover() const;
    /// A press there would begin a stroke.
    bool wouldStroke() const;
    /// Returns the vertices that a stroke of the ray brush would take first, if that was asked about.
    std::shared_ptr<const core::Footprint> footprint() const;
    /// The line that an open stroke shows, in pixels: the string of a steady one, the way dragged of an anchored one.
    struct Stabilizer
    {
        OrbitCamera::Pixel pointer, brush;
    };
    std::optional<Stabilizer> stabilizer() const;
    /// Returns the logical pixels that 1 mm covers at the cursor, else at the depth that the view turns about.
    double pixelsPerMm() const;
    bool strokeOpen() const { return m_drag == Drag::Stroke; }
    /// A press waits for its answer: a stroke may still come of it.
    bool isPressPending() const { return !m_pending.empty(); }
    /// Returns the settings of the open stroke, else of one that would begin now.
    core::StrokeSettings stroke() const;

Q_SIGNALS:
    /// Asks where the surface is, one request at a time. `brush`: its footprint is wanted, too; none for a spherical
    /// brush, whose region is seen without asking.
    void hoverRequested(const core::Ray& ray, const std::optional<core::StrokeSettings>& brush);
    void hoverChanged();
    /// A stroke: began, one sample or more (the first at the press), ended; in this order, never nested. Its placement
    /// is Ray. The settings are those at the press.
    void strokeBegan(const core::StrokeSettings& settings);
    /// Each event of mouse or pen, none left out. `time`: the event's own, seconds; `position`, `direction`: the ray
    /// through the pixel, in mm, not rounded to the lattice.
    void strokeSampled(const core::StrokeSample& sample);
    void strokeEnded(core::StrokeEnd how);
    void pressDecided();
    void modeChanged(ui::PointerMode mode);
    /// Tells of a press in Pick mode; nothing if it was not on the model.
    void picked(const std::optional<core::SurfaceHit>& hit);
    void viewChanged();
    /// The right button was clicked there.
    void paletteRequested(const ui::OrbitCamera::Pixel& pixel);
    /// The user turned, moved or zoomed the view; viewChanged() follows.
    void viewMovedByUser();
    /// One dab that adds a sphere of the brush's radius at the sample's position and does nothing else.
    void sphereRequested(const core::StrokeSettings& settings, const core::StrokeSample& sample);

private:
    /// An event with what was true when it came.
    struct PendingEvent
    {
        PointerEvent event;
        core::Ray ray;
        core::StrokeSettings settings; ///< of a press
        double stabilizerLength = 0;   ///< pixels; of a press
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
    OrbitCamera::Pixel m_pressed{0, 0};       ///< where the drag began
    std::optional<core::SurfaceHit> m_anchor; ///< the place there, of an anchored stroke
    OrbitCamera::Pixel m_last{0, 0};
    bool m_hasMoved = false; ///< farther than a click, in the present drag
    bool m_inside = false;
    bool m_isGesture = false; ///< fingers are inside, no pointer
    PointerMode m_mode = PointerMode::Sculpt;
    InputPreferences m_preferences;
    Qt::KeyboardModifiers m_modifiers;
    bool m_isEraser = false;            ///< the last that moved
    std::deque<PendingEvent> m_pending; ///< the first is a press that nobody knows about yet
};
} // namespace ui
