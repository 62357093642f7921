#pragma once

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
/// stroke. Gui thread, no widget, no OpenGL.
class PointerInput : public QObject
{
    Q_OBJECT

public:
    /// Neither is owned.
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
    /// Ends whatever drag is going on, as a release would.
    void finish();
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
    /// What was known belongs to another model.
    void clearHover();

    void setHover(const std::optional<core::SurfaceHit>& hit,
                  const std::shared_ptr<const core::Footprint>& footprint = {});

    /// While on, the next press for the brush does nothing but tell what it is on by picked(), and that was that.
    void setPicking(bool on);
    bool isPicking() const { return m_isPicking; }

    /// While on, a press on the model does nothing: the hand points.
    void setPointing(bool on);
    bool isPointing() const { return m_isPointing; }
    /// Where; nothing: beside the model, or the hand does something else.
    std::optional<core::SurfaceHit> pointed() const;

    /// Armed: the next left press anywhere asks for a sphere, and disarms.
    void setAdding(bool adding);
    bool isAdding() const { return m_isAdding; }

    /// Where the cursor is to lie: the newest answer, unless the pointer left or turns the view; if armed, where the
    /// sphere would be.
    std::optional<core::SurfaceHit> hover() const;
    /// A press there would begin a stroke.
    bool wouldStroke() const;
    /// What it would take first, if that was asked about: of the ray brush.
    std::shared_ptr<const core::Footprint> footprint() const;
    /// Of a steady stroke that is open.
    struct Stabilizer
    {
        OrbitCamera::Pixel pointer, brush;
    };
    std::optional<Stabilizer> stabilizer() const;
    bool strokeOpen() const { return m_drag == Drag::Stroke; }
    /// A press waits for its answer: a stroke may still come of it.
    bool isPressPending() const { return !m_pending.empty(); }
    /// Of the open stroke, else of one that would begin now.
    core::StrokeSettings stroke() const;

Q_SIGNALS:
    void hoverRequested(const core::Ray& ray, const std::optional<core::StrokeSettings>& brush);
    void hoverChanged();
    void strokeBegan(const core::StrokeSettings& settings);
    void strokeSampled(const core::StrokeSample& sample);
    void strokeEnded();
    void pressDecided();
    void pickingChanged(bool on);
    void pointingChanged(bool on);
    void picked(const std::optional<core::SurfaceHit>& hit);
    void viewChanged();
    /// The user turned, moved or zoomed the view; viewChanged() follows.
    void viewMovedByUser();
    void addingChanged(bool adding);
    /// One dab that is to add a sphere and do nothing else.
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
    struct HoverQuery
    {
        OrbitCamera::Pixel pixel;
        core::Ray ray;
        bool forPress = false;
        quint64 view = 0;  ///< m_view when it was asked
        double turned = 0; ///< how the model stood then
    };

    void process(const PendingEvent& pending);
    void press(const PendingEvent& pending);
    void move(const PendingEvent& pending);
    void begin(const PendingEvent& press, const std::optional<core::SurfaceHit>& hit);
    void end();
    void processPending(const std::optional<core::SurfaceHit>& hit);
    core::StrokeSettings strokeFor(Qt::KeyboardModifiers modifiers, bool eraser) const;
    bool movesView() const;
    OrbitCamera::Pixel brushAt() const;
    bool isUndecided(const PointerEvent& event) const;
    void setTargetDepthAt(const OrbitCamera::Pixel& pixel);
    void requestHover(HoverQuery query);
    void sendQuery(const HoverQuery& query);
    bool addsSphere(const PointerEvent& press) const;
    void addSphere(const PendingEvent& press);
    void moveView(const OrbitCamera::Pixel& delta);
    void emitViewMovedByUser();

    const BrushSettings* m_brush;
    OrbitCamera* m_camera;
    StrokeBuilder m_stroke;

    Drag m_drag = Drag::None;
    Qt::MouseButton m_dragButton = Qt::NoButton;
    OrbitCamera::Pixel m_pressed{0, 0}; ///< where the drag began
    OrbitCamera::Pixel m_last{0, 0};
    bool m_inside = false;
    bool m_isGesture = false; ///< fingers are inside, no pointer
    bool m_isPicking = false;
    bool m_isPointing = false;
    bool m_isAdding = false;
    InputPreferences m_preferences;
    Qt::KeyboardModifiers m_modifiers;
    bool m_isEraser = false;            ///< the last that moved
    std::deque<PendingEvent> m_pending; ///< the first is a press that nobody knows about yet

    quint64 m_view = 0; ///< grows when an older answer no longer fits
    std::optional<HoverQuery> m_inFlight, m_next;
    std::optional<OrbitCamera::Pixel> m_answeredPixel; ///< none: the answer is not of this view, or there is none
    std::optional<core::SurfaceHit> m_hit;
    std::shared_ptr<const core::Footprint> m_footprint; ///< at the hit, unless the surface changed
};
} // namespace ui
