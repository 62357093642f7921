#pragma once

#include "app/worker/job_queue.h"
#include "app/worker/stroke_report.h"

namespace app
{
/// Returns whether the brush is a sphere centred at the input's position instead of a point on the surface.
bool isFree(const core::StrokeSettings& brush);

/// Performs strokes on the sculptor, one after the other, from their settings and samples to their reports. Thread:
/// mesh.
class StrokeRunner
{
public:
    /// Result of one sample.
    struct Effect
    {
        quint64 topologyChanges = 0; ///< number of times that surfaces joined or parted
        core::Shortfall shortfall = core::Shortfall::None;
    };

    /// Sets the sculptor, which must stay valid until the next call, and its after-dab hook. Null: strokes do nothing.
    void setSculptor(core::Sculptor* sculptor);

    void begin(const BeginStroke& stroke);
    /// Adds a sample. Returns nothing if the sample has no effect. `isNewest`: no other sample waits, so an anchored
    /// stroke shows its present result.
    std::optional<Effect> add(const core::StrokeSample& sample, bool isNewest);
    /// Ends the stroke and returns its report, without facts. The report of a stroke that is taken back has no step.
    StrokeReport end(core::StrokeEnd how = core::StrokeEnd::Kept);
    /// Performs the replacement from begin() to end(). If it is stopped, the mesh is restored, and the undone stroke is
    /// applied again.
    StrokeReport replace(const StrokeReplacement& replacement);

    Source source() const { return m_stroke.source; }

private:
    bool touches(const core::StrokeSample& sample) const;
    bool isOver(const core::StrokeSample& sample);
    void apply(const core::StrokeSample& sample, bool isShown);
    void forgetDabs();
    void note(const core::DabReport& dab);
    void takeBack();
    quint64 topologyChanges() const;

    core::Sculptor* m_sculptor = nullptr;
    BeginStroke m_stroke;                      ///< the present stroke
    bool m_isOver = false;                     ///< true once a stroke that only adds a solid has got its first sample
    std::vector<core::StrokeSample> m_samples; ///< samples of the present stroke, for its record
    core::Shortfall m_shortfall{};             ///< shortfall of the last sample's dabs
    StrokeReport m_report;
    quint64 m_fusionsBefore = 0; ///< number of fusions before the present stroke
};
} // namespace app
