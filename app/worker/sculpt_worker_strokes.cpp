// What the mesh thread does for a hand: its strokes, and where its brush would meet the surface.

#include "app/worker/sculpt_worker.h"

#include "app/worker/stroke_step.h"

#include "core/journal/journal.h"
#include "core/stroke/radial_symmetry.h"

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
/// A ball that stands where the hand is.
bool isInHand(const std::optional<core::StrokeSettings>& brush)
{
    return brush && brush->brush == core::BrushShape::Sphere && brush->place == core::Placement::Point;
}

bool canAdd(const core::StrokeSettings& settings)
{
    return settings.add && core::canAddSolid(settings.tool) && isInHand(settings);
}

std::uint64_t meetingsOf(const core::Sculptor& sculptor)
{
    const core::SculptorTotals totals = sculptor.totals();
    return totals.fusions + totals.separations;
}
} // namespace

std::optional<core::SurfaceHit> SculptWorker::placeOf(const Question& question) const
{
    return isInHand(question.brush) ? m_sculptor->nearest(question.ray.origin, question.brush->radius)
                                    : m_sculptor->hit(question.ray);
}

void SculptWorker::run(const Question& question)
{
    const auto hit = m_sculptor ? placeOf(question) : std::nullopt;
    std::shared_ptr<const core::Footprint> footprint;
    if (hit && question.brush && !isInHand(question.brush))
        footprint = std::make_shared<core::Footprint>(m_sculptor->footprint(*question.brush, hit->position));
    if (question.source == Source::Desktop)
        m_mailbox.post([this, hit, footprint, epoch = m_epoch] { Q_EMIT answeredDesktop(hit, footprint, epoch); });
    else
        Q_EMIT answeredHeadset(hit, footprint, m_epoch);
}

/// Whether a pull here would move something instead of adding a sphere, at this place, in another sector or at a mirror
/// image.
bool SculptWorker::touches(const core::StrokeSample& sample) const
{
    const core::Vec3 position = sample.rotation.conjugate() * sample.position;
    return std::ranges::any_of(core::imagesOf(position, m_stroke.settings), [&](const core::Vec3& place) {
        return m_sculptor->nearest(place, m_stroke.settings.radius).has_value();
    });
}

void SculptWorker::run(BeginStroke& job)
{
    m_report = {};
    m_report.tool = job.settings.tool;
    m_report.hasModel = job.settings.model != nullptr;
    m_stroke = job;
    m_course = canAdd(job.settings) ? Course::Undecided : Course::Open;
    m_samples.clear();
    ++m_scanGeneration;
    if (!m_sculptor)
        return;
    m_fusionsBefore = m_sculptor->totals().fusions;
    if (m_course == Course::Open)
        m_sculptor->beginStroke(job.settings);
}

/// A ball, or a stroke; where only a ball was wanted, nothing.
void SculptWorker::decide(const core::StrokeSample& first)
{
    const bool isTouching = touches(first);
    if (isTouching && m_stroke.onlyAdds) {
        m_report.shortfall = core::Shortfall::TooClose;
        m_course = Course::Over;
        return;
    }
    m_course = Course::Open;
    m_stroke.settings.add = !isTouching;
    m_sculptor->beginStroke(m_stroke.settings);
}

/// Whether the stroke, with this sample, has nothing more to do.
bool SculptWorker::isOver(const core::StrokeSample& sample)
{
    if (m_sculptor && m_course == Course::Undecided)
        decide(sample);
    if (!m_sculptor || m_course == Course::Over)
        return true;
    if (canAdd(m_stroke.settings)) // a hand that pulls faster than the clay follows leaves no row of balls
        m_course = Course::Over;
    return false;
}

void SculptWorker::run(Sample& job)
{
    if (isOver(job.sample))
        return;
    m_sampledNs = job.postedNs;
    const std::uint64_t before = meetingsOf(*m_sculptor);
    const core::Shortfall shortfall = apply(job.sample);
    if (m_stroke.source == Source::Headset)
        Q_EMIT sampledHeadset(meetingsOf(*m_sculptor) - before, shortfall);
    {
        const std::lock_guard lock(m_mutex);
        ++m_stats.samples;
    }
    if (!m_queue.hasSample() || isFlushDue())
        flushPatch();
    m_sampledNs = 0;
}

core::Shortfall SculptWorker::apply(const core::StrokeSample& sample)
{
    m_samples.push_back(sample);
    core::Shortfall shortfall = core::Shortfall::None;
    const std::vector<core::DabReport> dabs = m_sculptor->addSample(sample);
    m_report.dabs += dabs.size();
    for (const core::DabReport& dab : dabs) {
        shortfall = std::max(shortfall, core::shortfallOf(dab));
        m_report.added = m_report.added || dab.outcome == core::DabOutcome::Added;
        m_report.asymmetric = m_report.asymmetric || dab.asymmetric;
        m_report.sequential = m_report.sequential || dab.sequential;
    }
    m_report.shortfall = std::max(m_report.shortfall, shortfall);
    return shortfall;
}

void SculptWorker::run(EndStroke&)
{
    if (m_sculptor) {
        auto delta =
            std::make_shared<core::MeshDelta>(m_sculptor->strokeOpen() ? m_sculptor->endStroke() : core::MeshDelta());
        if (!delta->empty()) {
            m_report.delta = std::move(delta);
            m_report.recordedStep = std::make_shared<const core::FileEntry>(
                core::Stroke{m_stroke.settings, std::exchange(m_samples, {}), {}, {}});
        }
        m_report.fusions = m_sculptor->totals().fusions - m_fusionsBefore;
    }
    report();
}

void SculptWorker::report()
{
    if (m_sculptor) {
        flushPatch();
        m_report.facts = facts();
        if (m_journal && m_report.delta)
            record(*m_report.delta);
        startScan();
    }
    notify([this, report = std::exchange(m_report, {})] { Q_EMIT strokeFinished(report); });
}

void SculptWorker::record(const core::MeshDelta& delta)
{
    const StepDescription step = StrokeStep::descriptionOf(m_report);
    m_journal->changed(m_sculptor->mesh(), delta, StrokeStep::forJournal(step.text, step.marks));
}
} // namespace app
