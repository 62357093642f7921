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
/// The mesh thread. It owns the sculptor, runs jobs in the order in which they were posted, and answers questions
/// between the engine's sub-steps. Every function except the constructor, stop() and the destructor may be called from
/// any thread and returns at once. Unless stated otherwise, signals are emitted by the event loop of the thread that
/// made the worker.
class SculptWorker : public QObject
{
    Q_OBJECT

public:
    explicit SculptWorker(QObject* parent = nullptr);
    ~SculptWorker() override;

    /// Ends the thread after the present job, and drops all other jobs.
    void stop();

    /// Sets the inbox from which viewer `source` draws. It gets the whole mesh first, then the changes. Null: none.
    void setInbox(Source source, std::shared_ptr<PatchInbox> inbox);
    /// Returns the gate to which strokes are posted.
    StrokeGate& strokes() { return m_gate; }
    /// Withholds later changes from the viewers until the next replaceLastStroke() is done.
    void hidePatches();
    /// Replaces the last stroke, without dropping samples. Emits strokeFinished(). Precondition: strokes() is held.
    void replaceLastStroke(const StrokeReplacement& replacement);

    /// Selects the part that later strokes and questions refer to. A new model begins with its first part.
    void activate(core::PartId part);

    /// Posts a viewer's Question. Only the viewer's newest question is answered, once, by its answered...() signal.
    void ask(Source source, const core::Ray& ray, const std::optional<core::StrokeSettings>& brush = {});

    /// Replaces the model, and puts the new one into every inbox. Ends an open stroke first. `journal` records each
    /// stroke, and signals wait until the changes before them are recorded; null: nothing is recorded.
    void setModel(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal = {});
    /// Records later changes in another journal.
    void setJournal(std::shared_ptr<core::Journal> journal);
    /// Runs a job on the mesh thread, in order with strokes and samples. Viewers get its changes. Without a model the
    /// job is dropped.
    void post(std::function<void(core::Sculptor&)> job);
    /// Emits confirmed() once everything posted before is done and recorded, so that it would survive a crash.
    void confirm();

    WorkerStats stats() const;

Q_SIGNALS:
    /// Emitted when the model of setModel() is in place.
    void modelSet(const app::MeshFacts& facts);
    /// Emitted when a stroke is finished and recorded.
    void strokeFinished(const app::StrokeReport& report);
    /// Answers confirm().
    void confirmed();
    /// Emitted when the list of parts has changed, before modelSet() or the confirmed() of the change.
    void partsChanged(const core::PartList& parts);
    /// Answers ask(Source::Desktop, ...). `footprint`: footprint of the question's brush if it follows the surface and
    /// the ray hits; null otherwise. `epoch`: epoch of the last patch that viewers got before the answer.
    void answeredDesktop(const std::optional<core::SurfaceHit>& hit,
                         const std::shared_ptr<const core::Footprint>& footprint, quint64 epoch);
    /// Answers ask(Source::Headset, ...). Thread: mesh, so that the window cannot delay it; use a direct connection.
    void answeredHeadset(const std::optional<core::SurfaceHit>& hit,
                         const std::shared_ptr<const core::Footprint>& footprint, quint64 epoch);
    /// Answers ask(Source::Simulator, ...).
    void answeredSimulator(const std::optional<core::SurfaceHit>& hit);
    /// Emitted after each sample of the headset that the stroke has used. `fusions`: number of times that surfaces
    /// joined or parted. `shortfall`: the most important shortfall of the sample's dabs. Thread: mesh; use a direct
    /// connection.
    void sampledHeadset(quint64 fusions, core::Shortfall shortfall);
    /// Emitted with the exact facts some time after the last change.
    void factsChanged(const app::MeshFacts& facts);

private:
    void run();
    void run(const Question& question);
    void run(BeginStroke& job);
    void run(Sample& job);
    void run(EndStroke& job);
    void run(Task& job);
    void finish(StrokeReport report);
    std::optional<core::Part> partOfStep(const StrokeReport& report) const;
    void install(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal);
    void replaceJournal(std::shared_ptr<core::Journal> journal);
    void notify(std::function<void()> notification);
    void betweenSubsteps();
    bool flushPatch(); ///< returns whether there was a patch
    void reportParts();

    ui::ThreadMailbox m_mailbox;
    JobQueue m_queue;
    StrokeGate m_gate;

    // State of the mesh thread.
    std::shared_ptr<core::Sculptor> m_sculptor;
    std::shared_ptr<core::Journal> m_journal;
    core::PartId m_part = 0; ///< the active part
    core::PartList m_parts;  ///< the list that partsChanged() last reported
    StrokeRunner m_runner;
    PatchPublisher m_publisher;
    MeshFactsScan m_scan;

    std::thread m_thread; ///< last member: the thread uses the other members
};
} // namespace app
