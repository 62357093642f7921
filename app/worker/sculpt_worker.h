#pragma once

#include "app/worker/mesh_facts_scan.h"
#include "app/worker/patch_publisher.h"
#include "app/worker/stroke_gate.h"
#include "app/worker/stroke_runner.h"

#include "core/mesh/surface_hit.h"
#include "ui/util/thread_mailbox.h"

#include <QObject>

#include <thread>

namespace core
{
struct Footprint;
class Journal;
} // namespace core

namespace app
{
/// The mesh thread. It owns the sculptor, takes jobs in the order in which they were posted, and answers questions
/// between the engine's sub-steps. Every function except the constructor, stop() and the destructor may be called from
/// any thread and returns at once. Signals come on the thread that made the worker, by its event loop.
class SculptWorker : public QObject
{
    Q_OBJECT

public:
    explicit SculptWorker(QObject* parent = nullptr);
    ~SculptWorker() override;

    /// Ends the thread after the job at hand; the others are dropped.
    void stop();

    /// What viewer `source` draws from. It gets the whole mesh first, then what changes.
    void setInbox(Source source, std::shared_ptr<PatchInbox> inbox);
    /// Where strokes come in.
    StrokeGate& strokes() { return m_gate; }
    /// Viewers see nothing of what follows until the next replaceLastStroke() is done.
    void hidePatches();
    /// Precondition: strokes() is held. None of its samples is dropped, and it is reported as any stroke.
    void replaceLastStroke(const StrokeReplacement& replacement);

    /// The newest question of a source is answered once, by its answered signal; those that it overtook are not. See
    /// Question.
    void ask(Source source, const core::Ray& ray, const std::optional<core::StrokeSettings>& brush = {});

    /// Puts another model in place of the present one, and into every inbox. A stroke that is open ends before.
    /// `journal` hears of each stroke, and no signal tells of one that is not recorded; null: none is.
    void setModel(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal = {});
    /// Another journal hears of what follows.
    void setJournal(std::shared_ptr<core::Journal> journal);
    /// Runs a job on the mesh thread between strokes and samples; viewers get what it changed. Not run without a model.
    void post(std::function<void(core::Sculptor&)> job);
    /// confirmed(), once what was posted before is done and would survive the program.
    void confirm();

    WorkerStats stats() const;

Q_SIGNALS:
    void modelSet(const app::MeshFacts& facts);
    void strokeFinished(const app::StrokeReport& report);
    /// To confirm().
    void confirmed();
    /// To ask(Source::Desktop, ...). `footprint`: of the brush, if one was asked about and the ray hits. `epoch`: of
    /// the last patch that viewers were given before.
    void answeredDesktop(const std::optional<core::SurfaceHit>& hit,
                         const std::shared_ptr<const core::Footprint>& footprint, quint64 epoch);
    /// To ask(Source::Headset, ...); on the mesh thread, so that nobody waits for a window: connect it directly.
    void answeredHeadset(const std::optional<core::SurfaceHit>& hit,
                         const std::shared_ptr<const core::Footprint>& footprint, quint64 epoch);
    /// What a sample of the headset's did: surfaces joined or parted, and the one shortfall of its dabs that is most
    /// worth telling; on the mesh thread, as the answers.
    void sampledHeadset(quint64 fusions, core::Shortfall shortfall);
    /// Exact, some time after the last change.
    void factsChanged(const app::MeshFacts& facts);

private:
    void run();
    void run(const Question& question);
    void run(BeginStroke& job);
    void run(Sample& job);
    void run(EndStroke& job);
    void run(Task& job);
    void finish(StrokeReport report);
    void install(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal);
    void replaceJournal(std::shared_ptr<core::Journal> journal);
    void notify(std::function<void()> notification);
    void betweenSubsteps();
    bool flushPatch(); ///< whether there was anything

    ui::ThreadMailbox m_mailbox;
    JobQueue m_queue;
    StrokeGate m_gate;

    // The mesh thread's own.
    std::shared_ptr<core::Sculptor> m_sculptor;
    std::shared_ptr<core::Journal> m_journal;
    StrokeRunner m_runner;
    PatchPublisher m_publisher;
    MeshFactsScan m_scan;

    std::thread m_thread; ///< last: it uses the others
};
} // namespace app
