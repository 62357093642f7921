#pragma once

#include "vr/scene/scene_state.h"
#include "vr/sculpt/brush_state.h"
#include "vr/sculpt/document_port.h"

namespace vr
{
/// The brush in the sculpting hand: the stroke that it draws in the document, and what of the surface it meets. The
/// headset's thread.
class WandBrush
{
public:
    /// The port must outlive it.
    WandBrush(DocumentPort* port, ButtonPreset preset);

    const BrushState& state() const { return m_state; }
    /// Takes what the window changed of the brush. A radius in mm becomes that length on the model as it is shown.
    /// Whether edges are uniform is the window's, too; otherwise the headset keeps its own topology, as its preset has.
    void take(const DocumentUpdate& update, const ModelPlacement& placement);
    /// By a hand or a panel; the window hears of what it has, too.
    void change(const BrushState& state);

    /// False: it is refused. Where Smooth is not offered, the brush's own tool sculpts instead.
    bool begin(BeginStroke begin, const ModelPlacement& placement);
    void draw(const StrokePoint& point, const ModelPlacement& placement);
    void end();

    /// Once a frame, before the others: where the wand's tip is; nothing while it is not seen.
    void aim(const std::optional<Pose>& tip) { m_tip = tip; }
    /// Once a frame: asks where it would meet the surface, and takes what was answered.
    void querySurface(const ModelPlacement& placement);
    /// Whether a ball at the tip reaches the surface, as far as it is known: what was answered for another place does
    /// not count.
    bool touches(const ModelPlacement& placement) const;
    /// How strongly it sculpts, 0 to 1; 0: it does not.
    double pressure() const { return m_pressure; }
    /// Metres from the tip along the ray to the surface, as far as it is known; the same.
    std::optional<double> reach(const ModelPlacement& placement) const;

    /// What is seen of it.
    std::variant<std::monostate, BallBrush, RayBrush> shown(const ModelPlacement& placement) const;
    /// What a ray brush would take; null: nothing, or it is not known.
    const std::shared_ptr<const core::Footprint>& footprint() const { return m_queryResult.footprint; }

private:
    core::StrokeSettings settings(const ModelPlacement& placement) const
    {
        return strokeSettings(m_state, {}, placement);
    }
    bool isRay() const { return m_state.stroke.brush == core::BrushShape::Ray; }

    DocumentPort* m_port;
    BrushState m_state;
    quint64 m_seenChange = 0, m_seenRadius = 0; ///< of the window
    bool m_smooths = true;                      ///< where a hand asks for it
    bool m_isDrawing = false;
    double m_pressure = 0;
    /// Seconds, of the first point: a runtime's clock may begin anywhere, files' times have bounds.
    std::optional<double> m_firstTime;
    std::optional<Pose> m_tip;
    SurfaceQueryResult m_queryResult;
};
} // namespace vr
