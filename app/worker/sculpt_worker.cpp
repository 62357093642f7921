// The thread's loop: each viewer's newest question, then the next job. A stroke's jobs are BeginStroke, Sample...,
// EndStroke; what the engine changed goes to the viewers' inboxes at a sub-step's end, at most once a frame while
// samples wait.
#include "app/worker/sculpt_worker.h"

#include "core/journal/journal.h"

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
constexpr std::int64_t flushIntervalNs = 8'000'000; ///< half a frame of a 60 Hz screen
constexpr core::Slot slotsAScan = 1 << 16;          ///< well below a millisecond

/// 0 of a free face: its corners are one.
double areaOf(const core::Mesh& mesh, core::Slot f)
{
    const core::Triangle& t = mesh.corners(f);
    const core::Vec3f &a = mesh.point(t[0]), &b = mesh.point(t[1]), &c = mesh.point(t[2]);
    return static_cast<double>((b - a).cross(c - a).norm()) / 2;
}
} // namespace

SculptWorker::SculptWorker(QObject* parent) : QObject(parent), m_thread([this] { run(); }) {}

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
        journal->drain(); // its callbacks use this object
}

void SculptWorker::setInbox(Source source, std::shared_ptr<PatchInbox> inbox)
{
    m_queue.push(Task([this, source, inbox = std::move(inbox)] {
        m_inboxes[static_cast<std::size_t>(source)] = inbox;
        if (inbox && m_sculptor)
            inbox->put(m_sculptor->wholePatch());
    }));
}

bool SculptWorker::beginStroke(Source source, const core::StrokeSettings& settings)
{
    return begin({settings, source});
}

bool SculptWorker::begin(const BeginStroke& stroke)
{
    {
        const std::lock_guard lock(m_mutex);
        if (!m_openSource && !m_isHeld) {
            m_openSource = stroke.source;
            ++m_strokesBegun;
            m_queue.push(stroke);
            return true;
        }
    }
    Q_EMIT strokeRefused(stroke.source);
    return false;
}

void SculptWorker::addSample(Source source, const core::StrokeSample& sample)
{
    const std::lock_guard lock(m_mutex);
    if (m_openSource == source)
        m_queue.push(Sample{sample, steadyNs()});
}

void SculptWorker::endStroke(Source source)
{
    const std::lock_guard lock(m_mutex);
    if (m_openSource != source)
        return;
    m_openSource.reset();
    m_queue.push(EndStroke{});
}

bool SculptWorker::addSphere(Source source, const core::StrokeSettings& settings, const core::StrokeSample& sample)
{
    if (!begin({settings, source, true}))
        return false;
    addSample(source, sample);
    endStroke(source);
    return true;
}

bool SculptWorker::strokeOpen() const
{
    const std::lock_guard lock(m_mutex);
    return m_openSource.has_value();
}

bool SculptWorker::hold()
{
    const std::lock_guard lock(m_mutex);
    m_isHeld = !m_openSource;
    return m_isHeld;
}

void SculptWorker::release()
{
    const std::lock_guard lock(m_mutex);
    m_isHeld = false;
}

void SculptWorker::ask(Source source, const core::Ray& ray, const std::optional<core::StrokeSettings>& brush)
{
    m_queue.ask({source, ray, brush});
}

void SculptWorker::setModel(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal)
{
    const std::lock_guard lock(m_mutex);
    if (std::exchange(m_openSource, std::nullopt))
        m_queue.push(EndStroke{});
    m_queue.push(Task([this, sculptor = std::move(sculptor), journal = std::move(journal)]() mutable {
        install(std::move(sculptor), std::move(journal));
    }));
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
        if (flushPatch())
            startScan();
    }));
}

void SculptWorker::confirm()
{
    m_queue.push(Task([this] { notify([this] { Q_EMIT confirmed(); }); }));
}

WorkerStats SculptWorker::stats() const
{
    const std::lock_guard lock(m_mutex);
    WorkerStats stats = m_stats;
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

/// What is told is told in order, and not before it would survive the program.
void SculptWorker::notify(std::function<void()> notification)
{
    auto post = [this, notification = std::move(notification)]() mutable { m_mailbox.post(std::move(notification)); };
    if (m_journal)
        m_journal->after(std::move(post));
    else
        post();
}

void SculptWorker::run(Task& job)
{
    job();
}

void SculptWorker::install(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal)
{
    ++m_scanGeneration;
    replaceJournal(std::move(journal));
    m_sculptor = std::move(sculptor);
    m_sculptor->setBetweenSubsteps([this] { betweenSubsteps(); });
    m_sculptor->takePatch();
    m_box = {};
    m_area = 0;
    core::MeshPatch whole = m_sculptor->wholePatch();
    for (const core::DrawVertex& vertex : whole.vertices)
        m_box.extend(vertex.position.cast<double>());
    for (core::Slot f = 0; f < m_sculptor->mesh().slots().faces; ++f)
        m_area += areaOf(m_sculptor->mesh(), f);
    m_epoch = whole.epoch;
    notify([this, facts = facts()] { Q_EMIT modelSet(facts); });
    for (const auto& inbox : m_inboxes)
        if (inbox)
            inbox->put(whole);
}

void SculptWorker::replaceJournal(std::shared_ptr<core::Journal> journal)
{
    if (const auto before = std::exchange(m_journal, std::move(journal)))
        before->drain();
}

/// The mesh is valid here and its index up to date: viewers may see it and ask.
void SculptWorker::betweenSubsteps()
{
    for (const std::optional<Question>& question : m_queue.takeQuestions())
        if (question)
            run(*question);
    if (isFlushDue())
        flushPatch();
}

bool SculptWorker::isFlushDue() const
{
    return steadyNs() - m_flushedNs > flushIntervalNs;
}

bool SculptWorker::flushPatch()
{
    if (m_isQuiet)
        return false;
    m_flushedNs = steadyNs();
    core::MeshPatch patch = m_sculptor->takePatch();
    if (patch.empty())
        return false;
    patch.sampledNs = m_sampledNs;
    m_epoch = patch.epoch;
    for (const core::DrawVertex& vertex : patch.vertices)
        m_box.extend(vertex.position.cast<double>());
    for (const auto& inbox : m_inboxes)
        if (inbox)
            inbox->put(patch);
    measureLatency(patch.sampledNs);
    return true;
}

/// A box only grows by patches. What it really is, is found out in small jobs at the queue's end, which a stroke stops.
void SculptWorker::startScan()
{
    m_scannedBox.setEmpty();
    m_scannedArea = 0;
    m_queue.push(Task([this, generation = ++m_scanGeneration] { scan(0, generation); }));
}

void SculptWorker::scan(core::Slot first, std::uint64_t generation)
{
    if (generation != m_scanGeneration)
        return;
    const core::Mesh& mesh = m_sculptor->mesh();
    const core::Slot end = std::min(mesh.slots().vertices, first + slotsAScan);
    for (core::Slot v = first; v < end; ++v)
        if (mesh.isVertex(v))
            m_scannedBox.extend(mesh.point(v).cast<double>());
    for (core::Slot f = 2 * first; f < std::min(mesh.slots().faces, 2 * (first + slotsAScan)); ++f)
        m_scannedArea += areaOf(mesh, f);
    if (first + slotsAScan < std::max(mesh.slots().vertices, mesh.slots().faces / 2 + 1)) {
        m_queue.push(Task([this, first, generation] { scan(first + slotsAScan, generation); }));
        return;
    }
    m_box = m_scannedBox;
    m_area = m_scannedArea;
    notify([this, facts = facts()] { Q_EMIT factsChanged(facts); });
}

void SculptWorker::measureLatency(std::int64_t sampledNs)
{
    const std::lock_guard lock(m_mutex);
    ++m_stats.patches;
    if (sampledNs == 0)
        return;
    m_stats.latencyMs = static_cast<double>(steadyNs() - sampledNs) * 1e-6;
    m_stats.worstLatencyMs = std::max(m_stats.worstLatencyMs, m_stats.latencyMs);
}

MeshFacts SculptWorker::facts() const
{
    const core::Mesh& mesh = m_sculptor->mesh();
    return {mesh.live().vertices, mesh.live().faces, m_box, m_area, mesh.uniformDetail(), mesh.lattice().minDetail()};
}
} // namespace app
