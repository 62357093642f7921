#include "app/worker/stroke_runner.h"

#include "core/sculpt/sculptor.h"
#include "core/stroke/radial_symmetry.h"

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
bool canAdd(const core::StrokeSettings& settings)
{
    return settings.add && core::canAddSolid(settings.tool) && isFree(settings);
}

/// Returns whether the shortfall is a reason why a solid was not added.
bool isRefusal(core::Shortfall shortfall)
{
    using enum core::Shortfall;
    return shortfall == Inside || shortfall == TooClose || shortfall == NoRoom || shortfall == Unfit ||
           shortfall == Masked;
}
} // namespace

bool isFree(const core::StrokeSettings& brush)
{
    return brush.brush == core::BrushShape::Sphere && brush.place == core::Placement::Point;
}

void StrokeRunner::setSculptor(core::Sculptor* sculptor)
{
    m_sculptor = sculptor;
    if (sculptor)
        sculptor->setAfterDab([this](const core::DabReport& dab) { note(dab); });
}

void StrokeRunner::begin(const BeginStroke& stroke)
{
    m_stroke = stroke;
    m_isOver = false;
    m_samples.clear();
    forgetDabs();
    if (m_sculptor)
        m_sculptor->beginStroke(stroke.settings);
}

/// Clears the report. Called at the beginning of a stroke, or after its dabs were taken back.
void StrokeRunner::forgetDabs()
{
    m_report = {};
    m_report.tool = m_stroke.settings.tool;
    m_report.hasModel = m_stroke.settings.model != nullptr;
    if (m_sculptor)
        m_fusionsBefore = m_sculptor->totals().fusions;
}

/// Returns whether a pull would move vertices instead of adding a sphere, at this place or at any of its mirror and
/// radial images.
bool StrokeRunner::touches(const core::StrokeSample& sample) const
{
    const core::Vec3 position = sample.rotation.conjugate() * sample.position;
    return std::ranges::any_of(core::imagesOf(position, m_stroke.settings), [&](const core::Vec3& place) {
        return m_sculptor->nearest(place, m_stroke.settings.radius).has_value();
    });
}

/// Returns whether the sample has no effect. A stroke that only adds a solid does so at its first sample, and only if
/// it is allowed to join any surface that it touches.
bool StrokeRunner::isOver(const core::StrokeSample& sample)
{
    const core::StrokeSettings& settings = m_stroke.settings;
    if (!canAdd(settings) || !(m_stroke.onlyAdds || settings.join))
        return false;
    if (std::exchange(m_isOver, true))
        return true;
    const bool isRefused = !(settings.join && settings.fusion) && touches(sample);
    if (isRefused)
        m_report.shortfall = core::Shortfall::TooClose;
    return isRefused;
}

quint64 StrokeRunner::topologyChanges() const
{
    const core::SculptorTotals totals = m_sculptor->totals();
    return totals.fusions + totals.separations;
}

std::optional<StrokeRunner::Effect> StrokeRunner::add(const core::StrokeSample& sample, bool isNewest)
{
    if (!m_sculptor || isOver(sample))
        return std::nullopt;
    const quint64 before = topologyChanges();
    apply(sample, isNewest);
    return Effect{topologyChanges() - before, m_shortfall};
}

/// Adds the sample to the stroke. `isShown`: an anchored stroke shows its present dab. The dab shown before is taken
/// back, so it is removed from the report.
void StrokeRunner::apply(const core::StrokeSample& sample, bool isShown)
{
    using core::Sculptor;
    m_samples.push_back(sample);
    m_shortfall = core::Shortfall::None;
    if (core::isAnchored(m_stroke.settings) && core::isUsable(m_stroke.settings, sample))
        forgetDabs();
    m_sculptor->addSample(sample, isShown ? Sculptor::Anchored::Shown : Sculptor::Anchored::Waits);
}

void StrokeRunner::note(const core::DabReport& dab)
{
    const bool hasBegun = m_report.dabs++ > 0;
    if (hasBegun && dab.touchedVertices > 0 && isRefusal(m_report.shortfall))
        m_report.shortfall = core::Shortfall::None; // the first dab found nothing to pull, but this one does
    m_report.added = m_report.added || dab.outcome == core::DabOutcome::Added;
    m_report.asymmetric = m_report.asymmetric || dab.asymmetric;
    m_report.sequential = m_report.sequential || dab.sequential;
    m_shortfall = std::max(m_shortfall, core::shortfallOf(dab));
    m_report.shortfall = std::max(m_report.shortfall, m_shortfall);
}

StrokeReport StrokeRunner::end(core::StrokeEnd how)
{
    if (how == core::StrokeEnd::TakenBack) {
        takeBack();
        m_report = {};
    } else if (m_sculptor) {
        auto delta =
            std::make_shared<core::MeshDelta>(m_sculptor->strokeOpen() ? m_sculptor->endStroke() : core::MeshDelta());
        if (!delta->empty()) {
            m_report.delta = std::move(delta);
            m_stroke.settings.add = m_report.added;
            m_report.recordedStep = std::make_shared<const core::FileEntry>(
                core::Stroke{m_stroke.settings, std::exchange(m_samples, {}), {}, {}});
        }
        m_report.fusions = m_sculptor->totals().fusions - m_fusionsBefore;
    }
    return std::exchange(m_report, {});
}

/// Restores the mesh to its state before the present stroke.
void StrokeRunner::takeBack()
{
    if (m_sculptor && m_sculptor->strokeOpen())
        m_sculptor->endStroke(core::StrokeEnd::TakenBack);
}

StrokeReport StrokeRunner::replace(const StrokeReplacement& replacement)
{
    if (replacement.stroke) {
        const bool onlyAdds = replacement.before.added && replacement.stroke->samples.size() == 1;
        begin({replacement.stroke->settings, Source::Desktop, onlyAdds});
        for (const core::StrokeSample& sample : replacement.stroke->samples) {
            if (replacement.stop.stop_requested())
                break;
            if (m_sculptor && !isOver(sample))
                apply(sample, false);
        }
        if (!replacement.stop.stop_requested()) {
            m_report.isReplacement = true;
            return end();
        }
        takeBack();
    }
    StrokeReport report = replacement.before;
    report.isReplacement = true;
    report.delta = m_sculptor ? replacement.restoreReplaced(*m_sculptor) : nullptr;
    return report;
}
} // namespace app
