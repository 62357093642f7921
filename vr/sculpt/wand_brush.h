#pragma once

#include "vr/scene/scene_state.h"
#include "vr/sculpt/brush_state.h"
#include "vr/sculpt/document_port.h"

namespace vr
{
/// The brush of the sculpting hand. It draws strokes in the document and queries the surface near the brush. Thread:
/// the headset's.
class WandBrush
{
public:
    /// Precondition: `port` outlives this object.
    WandBrush(DocumentPort* port, ButtonPreset preset);

    const BrushState& state() const { return m_state; }
    /// Takes over the window's changes of the brush. A radius in mm becomes the length that it has on the model as
    /// shown. Uniform topology is taken from the window; otherwise the headset keeps its own topology, at first that of
    /// its preset.
    void take(const DocumentUpdate& update, const ModelPlacement& placement);
    /// Sets the brush after a change by a wand or a panel. If a setting that the window shares has changed, requests
    /// the change of the window's brush too.
    void change(const BrushState& state);

    /// Begins a stroke. Returns false if the stroke is refused. If smoothing is not offered, the brush's own tool is
    /// used instead.
    bool begin(BeginStroke begin, const ModelPlacement& placement);
    void draw(const StrokePoint& point, const ModelPlacement& placement);
    void end();

    /// Sets the pose of the wand's tip; none while it is not tracked. To be called once a frame, before the other
    /// functions.
    void aim(const std::optional<Pose>& tip) { m_tip = tip; }
    /// Takes the last answer, and asks where the brush would meet the surface now. To be called once a frame.
    void querySurface(const ModelPlacement& placement);
    /// Returns whether the brush meets the surface, by the last answered query. Outside a stroke this is true only for
    /// a spherical brush whose centre is within its radius of the last answered point.
    bool touches(const ModelPlacement& placement) const;
    /// Returns the pressure of the stroke, 0 to 1; 0: no stroke is open.
    double pressure() const { return m_pressure; }
    /// Returns the distance from the tip along the ray of a ray brush to the surface, metres; none if it is not known,
    /// or if the last answer is for another ray.
    std::optional<double> reach(const ModelPlacement& placement) const;

    /// Returns the appearance of the brush.
    std::variant<std::monostate, BallBrush, RayBrush> shown(const ModelPlacement& placement) const;
    /// Returns the footprint of a ray brush; null: the ray meets nothing, or the answer is not known yet.
    const std::shared_ptr<const core::Footprint>& footprint() const { return m_queryResult.footprint; }

private:
    core::StrokeSettings settings(const ModelPlacement& placement) const
    {
        return strokeSettings(m_state, {}, placement);
    }
    bool isRay() const { return m_state.stroke.brush == core::BrushShape::Ray; }

    DocumentPort* m_port;
    BrushState m_state;
    quint64 m_seenChange = 0, m_seenRadius = 0; ///< values of brushChange and radiusChange in the last DocumentUpdate
    bool m_smooths = true;                      ///< smoothing is offered by the window
    bool m_isDrawing = false;
    double m_pressure = 0;
    /// Time of the first point, seconds. It is subtracted from all times, because a runtime's clock may begin anywhere
    /// and the times in files are limited.
    std::optional<double> m_firstTime;
    std::optional<Pose> m_tip;
    SurfaceQueryResult m_queryResult;
};
} // namespace vr
