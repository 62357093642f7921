// The thread's loop answers each viewer's newest question, then runs the next job. A stroke consists of the jobs
// BeginStroke, Sample..., EndStroke. Changes are sent to the viewers' inboxes at the end of a sub-step, at most once
// per half frame while samples are waiting.
#include "app/worker/sculpt_worker.h"

#include "app/worker/stroke_step.h"

#include "core/journal/journal.h"
#include "core/sculpt/sculptor.h"

#include <utility>

namespace app
{
SculptWorker::SculptWorker(QObject* parent)
    : QObject(parent)
    , m_gate(&m_queue)
    , m_scan(&m_queue, [this] { notify([this, facts = m_scan.facts()] { Q_EMIT factsChanged(facts); }); })
    , m_thread([this] { run(); })
{}

SculptWorker::~SculptWorker()
{
    stop();
}

void SculptWorker::stop()
{
    m_queue.stop();
    if (m_thread.joinable())
        m_thread.join();
    if (const auto journal = std::exchange(m_journal, nullptr))
        journal->drain(); // the journal's callbacks use this object
}

void SculptWorker::setInbox(Source source, std::shared_ptr<PatchInbox> inbox)
{
    m_queue.push(Task([this, source, inbox = std::move(inbox)] {
        m_publisher.setInbox(source, inbox);
        if (inbox && m_sculptor)
            inbox->put(m_sculptor->wholePatch());
    }));
}

void SculptWorker::hidePatches()
{
    m_queue.push(Task([this] { m_publisher.setHidden(true); }));
}

void SculptWorker::replaceLastStroke(const StrokeReplacement& replacement)
{
    m_gate.countStroke();
    m_queue.push(Task([this, replacement] {
        m_scan.cancel();
        StrokeReport report = m_runner.replace(replacement);
        m_publisher.setHidden(false);
        finish(std::move(report));
    }));
}

void SculptWorker::ask(Source source, const core::Ray& ray, const std::optional<core::StrokeSettings>& brush)
{
    m_queue.ask({source, ray, brush});
}

void SculptWorker::setModel(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal)
{
    m_gate.pushAfterStroke([this, sculptor = std::move(sculptor), journal = std::move(journal)]() mutable {
        install(std::move(sculptor), std::move(journal));
    });
}

void SculptWorker::setJournal(std::shared_ptr<core::Journal> journal)
{
    m_queue.push(Task([this, journal = std::move(journal)]() mutable { replaceJournal(std::move(journal)); }));
}

void SculptWorker::post(std::function<void(core::Sculptor&)> job)
{
    m_queue.push(Task([this, job = std::move(job)] {
        if (!m_sculptor)
            return;
        job(*m_sculptor);
        reportParts();
        if (flushPatch())
            m_scan.start();
    }));
}

void SculptWorker::activate(core::PartId part)
{
    m_queue.push(Task([this, part] {
        m_part = part;
        if (m_sculptor && !m_sculptor->strokeOpen())
            m_sculptor->activate(part);
    }));
}

void SculptWorker::confirm()
{
    m_queue.push(Task([this] { notify([this] { Q_EMIT confirmed(); }); }));
}

WorkerStats SculptWorker::stats() const
{
    WorkerStats stats = m_publisher.stats();
    stats.droppedSamples = m_queue.droppedSamples();
    return stats;
}

void SculptWorker::run()
{
    while (auto work = m_queue.next()) {
        if (const auto* question = std::get_if<Question>(&*work))
            run(*question);
        else
            std::visit([this](auto& job) { run(job); }, std::get<Job>(*work));
    }
}

void SculptWorker::run(const Question& question)
{
    const bool isBrushFree = question.brush && isFree(*question.brush);
    std::optional<core::SurfaceHit> hit;
    if (m_sculptor)
        hit = isBrushFree ? m_sculptor->nearest(question.ray.origin, question.brush->radius)
                          : m_sculptor->hit(question.ray);
    std::shared_ptr<const core::Footprint> footprint;
    if (hit && question.brush && !isBrushFree)
        footprint = std::make_shared<core::Footprint>(m_sculptor->footprint(*question.brush, hit->position));
    const quint64 epoch = m_publisher.epoch();
    if (question.source == Source::Desktop)
        m_mailbox.post([this, hit, footprint, epoch] { Q_EMIT answeredDesktop(hit, footprint, epoch); });
    else if (question.source == Source::Simulator)
        m_mailbox.post([this, hit] { Q_EMIT answeredSimulator(hit); });
    else
        Q_EMIT answeredHeadset(hit, footprint, epoch);
}

void SculptWorker::run(BeginStroke& job)
{
    m_scan.cancel();
    job.settings.part = m_part;
    m_runner.begin(job);
}

void SculptWorker::run(Sample& job)
{
    m_publisher.beginSample(job.postedNs);
    if (const auto effect = m_runner.add(job.sample, !m_queue.hasSample())) {
        if (m_runner.source() == Source::Headset)
            Q_EMIT sampledHeadset(effect->topologyChanges, effect->shortfall);
        if (!m_queue.hasSample() || m_publisher.isDue())
            flushPatch();
    }
    m_publisher.countSample();
    m_publisher.endSample();
}

void SculptWorker::run(EndStroke& job)
{
    finish(m_runner.end(job.how));
}

void SculptWorker::run(Task& job)
{
    job();
}

void SculptWorker::finish(StrokeReport report)
{
    if (m_sculptor) {
        m_sculptor->activate(m_part);
        flushPatch();
        report.facts = m_scan.facts();
        report.part = partOfStep(report);
        if (m_journal && report.delta) {
            const StepDescription step = StrokeStep::descriptionOf(report);
            m_journal->changed(m_sculptor->mesh(), *report.delta, StrokeStep::forJournal(step.text, step.marks));
        }
        m_scan.start();
    }
    notify([this, report = std::move(report)] { Q_EMIT strokeFinished(report); });
}

/// Returns the part that the stroke changed; nothing if there is only one.
std::optional<core::Part> SculptWorker::partOfStep(const StrokeReport& report) const
{
    const core::PartList& parts = m_sculptor->mesh().frame().parts;
    const core::Part* part = report.stroke() ? parts.find(report.stroke()->settings.part) : nullptr;
    return part && parts.size() > 1 ? std::optional(*part) : std::nullopt;
}

/// Posts the notification to the gui thread, after all earlier changes have been recorded in the journal.
void SculptWorker::notify(std::function<void()> notification)
{
    auto post = [this, notification = std::move(notification)]() mutable { m_mailbox.post(std::move(notification)); };
    if (m_journal)
        m_journal->after(std::move(post));
    else
        post();
}

void SculptWorker::install(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal)
{
    replaceJournal(std::move(journal));
    m_sculptor = std::move(sculptor);
    m_part = m_sculptor->mesh().frame().parts.all().front().id;
    m_sculptor->activate(m_part);
    m_sculptor->setBetweenSubsteps([this] { betweenSubsteps(); });
    m_sculptor->takePatch();
    m_runner.setSculptor(m_sculptor.get());
    const core::MeshPatch whole = m_sculptor->wholePatch();
    m_scan.reset(&m_sculptor->mesh(), whole);
    reportParts();
    notify([this, facts = m_scan.facts()] { Q_EMIT modelSet(facts); });
    m_publisher.putWhole(whole);
}

void SculptWorker::replaceJournal(std::shared_ptr<core::Journal> journal)
{
    if (const auto before = std::exchange(m_journal, std::move(journal)))
        before->drain();
}

/// Answers questions and sends changes to the viewers. Precondition: the mesh is valid and its octree is up to date.
void SculptWorker::betweenSubsteps()
{
    for (const std::optional<Question>& question : m_queue.takeQuestions())
        if (question)
            run(*question);
    if (m_publisher.isDue())
        flushPatch();
}

bool SculptWorker::flushPatch()
{
    const std::optional<core::MeshPatch> patch = m_publisher.flush(*m_sculptor);
    if (patch)
        m_scan.extend(*patch);
    return patch.has_value();
}

/// Emits partsChanged() if the list differs from the one reported last. Strokes and questions do not change the list.
void SculptWorker::reportParts()
{
    const core::PartList& parts = m_sculptor->mesh().frame().parts;
    if (parts == m_parts)
        return;
    m_parts = parts;
    notify([this, parts] { Q_EMIT partsChanged(parts); });
}
} // namespace app
