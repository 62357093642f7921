#pragma once

#include "app/worker/job_queue.h"
#include "app/worker/stroke_report.h"

namespace app
{
/// A spherical brush whose centre is the input's own position, not a place on the surface.
bool isFree(const core::StrokeSettings& brush);

/// Does one stroke after the other on the sculptor, from its settings and samples to its report. Thread: mesh.
class StrokeRunner
{
public:
    /// The effect of one sample.
    struct Effect
    {
        quint64 topologyChanges = 0; ///< surfaces joined or parted
        core::Shortfall shortfall = core::Shortfall::None;
    };

    /// The sculptor must outlive the next call; its hook after dabs is this object's. Without one, strokes do nothing.
    void setSculptor(core::Sculptor* sculptor);

    void begin(const BeginStroke& stroke);
    /// Returns nothing if the stroke has nothing more to do. `isNewest`: no other sample waits, so an anchored stroke
    /// shows what it would be now.
    std::optional<Effect> add(const core::StrokeSample& sample, bool isNewest);
    /// Returns the report without facts; of a stroke that is taken back, without a step.
    StrokeReport end(core::StrokeEnd how = core::StrokeEnd::Kept);
    /// Runs begin(), add() and end(). A replacement that is stopped leaves the mesh as it was, and the stroke before
    /// comes back.
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
    BeginStroke m_stroke;                      ///< in work
    bool m_isOver = false;                     ///< the stroke was only to add a solid, and its first sample has come
    std::vector<core::StrokeSample> m_samples; ///< of the stroke in work, for its record
    core::Shortfall m_shortfall{};             ///< of the last sample's dabs
    StrokeReport m_report;
    quint64 m_fusionsBefore = 0; ///< the stroke
};
} // namespace app
