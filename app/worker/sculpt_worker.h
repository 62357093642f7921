#pragma once

#include "app/worker/job_queue.h"
#include "app/worker/patch_inbox.h"

#include "core/io/stroke/stroke_file.h"
#include "core/sculpt/sculptor.h"
#include "ui/util/thread_mailbox.h"

#include <QObject>

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

namespace core
{
class Journal;
}

namespace app
{
/// What people want to know of the mesh.
struct MeshFacts
{
    quint64 vertices = 0;
    quint64 faces = 0;
    core::Box box;            ///< mm; right after a stroke it may still be larger than the mesh
    double area = 0;          ///< mm^2; of the mesh some time ago, as the box
    double uniformDetail = 0; ///< mm
    double minDetail = 0;     ///< mm; the finest d_detail that the lattice holds
};

/// A stroke that has ended, in the order of the strokes' beginnings.
struct StrokeReport
{
    std::shared_ptr<core::MeshDelta> delta;              ///< already applied; null if nothing changed
    std::shared_ptr<const core::FileEntry> recordedStep; ///< a core::Stroke, that did it; null if nothing changed
    core::Tool tool = core::Tool::Pull;
    quint64 dabs = 0;
    quint64 fusions = 0;
    core::Shortfall shortfall = core::Shortfall::None; ///< of the dabs the one most worth telling
    bool added = false;                                ///< a sphere, or the brush's model
    bool hasModel = false;                             ///< the brush
    bool asymmetric = false; ///< mirrored where the model is not symmetric: some dabs were done as two
    /// Radial where the model is not its own image by the turn, or over the axis: some dabs were done one after the
    /// other.
    bool sequential = false;
    bool isReplacement = false; ///< of replaceLastStroke()
    MeshFacts facts;

    /// The same: null if nothing changed.
    const core::Stroke* stroke() const { return std::get_if<core::Stroke>(recordedStep.get()); }
};

/// Another stroke in the place of one that was undone.
struct StrokeReplacement
{
    StrokeReport before; ///< of the one that was undone
    std::function<std::shared_ptr<core::MeshDelta>(core::Sculptor&)>
        restoreReplaced;                        ///< applies its change again; thread: mesh
    std::shared_ptr<const core::Stroke> stroke; ///< null: the one that was undone comes back, bit for bit
    std::stop_token stop;                       ///< the same, if this is not done yet
};

struct WorkerStats
{
    quint64 samples = 0; ///< that the engine consumed
    quint64 droppedSamples = 0;
    quint64 patches = 0;
    double latencyMs = 0; ///< from a sample's post to its patch in the inbox, the last
    double worstLatencyMs = 0;
};

/// The mesh thread. It owns the sculptor, takes jobs in the order in which they were posted, and answers questions
/// between the engine's sub-steps. Every function but the constructor, stop() and the destructor may be called from any
/// thread and returns at once. Signals come on the thread that made the worker, by its event loop.
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

    /// One stroke is open at a time: false, and strokeRefused() from here, if another source's is. Each stroke that was
    /// begun is reported once by strokeFinished(). A pull that may add a sphere (settings.add) adds one by its first
    /// sample, and the others do nothing; where the brush touches the surface at the first, it is a pull like any
    /// other.
    bool beginStroke(Source source, const core::StrokeSettings& settings);
    void addSample(Source source, const core::StrokeSample& sample);
    void endStroke(Source source);
    /// A stroke of one sample that adds a sphere at its position (settings.add) and does nothing else: where the brush
    /// would touch the surface it is refused as too close. As beginStroke().
    bool addSphere(Source source, const core::StrokeSettings& settings, const core::StrokeSample& sample);
    bool strokeOpen() const;
    /// Viewers see nothing of what follows until the next replaceLastStroke() is done.
    void hidePatches();
    /// Only while it is held: none of its samples is dropped, and it is reported as any stroke.
    void replaceLastStroke(const StrokeReplacement& replacement);
    /// From now on strokes are refused: the mesh stays as it is but for jobs. False if a stroke is open.
    bool hold();
    void release();
    /// Ever.
    quint64 strokesBegun() const { return m_strokesBegun; }

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
    void strokeRefused(app::Source source);
    /// To confirm().
    void confirmed();
    /// To ask(Source::Desktop, ...). `footprint`: of the brush, if one was asked about and the ray hits. `epoch`: of
    /// the last patch that viewers were given before.
    void answeredDesktop(const std::optional<core::SurfaceHit>& hit,
                         const std::shared_ptr<const core::Footprint>& footprint, quint64 epoch);
    /// To ask(Source::Headset, ...); on the mesh thread, so that nobody waits for a window: connect it directly.
    void answeredHeadset(const std::optional<core::SurfaceHit>& hit,
                         const std::shared_ptr<const core::Footprint>& footprint, quint64 epoch);
    /// What a sample of the headset's did: surfaces joined or parted, and of its dabs what is most worth telling; on
    /// the mesh thread, as the answers.
    void sampledHeadset(quint64 fusions, core::Shortfall shortfall);
    /// Exact, some time after the last change.
    void factsChanged(const app::MeshFacts& facts);

private:
    bool begin(const BeginStroke& stroke);
    void run();
    void run(const Question& question);
    std::optional<core::SurfaceHit> placeOf(const Question& question) const;
    bool touches(const core::StrokeSample& sample) const;
    void decide(const core::StrokeSample& first);
    core::Shortfall apply(const core::StrokeSample& sample);
    bool isOver(const core::StrokeSample& sample);
    bool doAgain(const StrokeReplacement& replacement);
    void restoreReplaced(const StrokeReplacement& replacement);
    void report();
    void run(BeginStroke& job);
    void run(Sample& job);
    void run(EndStroke& job);
    void run(Task& job);
    void install(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal);
    void replaceJournal(std::shared_ptr<core::Journal> journal);
    void record(const core::MeshDelta& delta);
    void notify(std::function<void()> notification);
    void betweenSubsteps();
    bool isFlushDue() const;
    bool flushPatch(); ///< whether there was anything
    void startScan();
    void scan(core::Slot first, std::uint64_t generation);
    void measureLatency(std::int64_t sampledNs);
    MeshFacts facts() const;

    ui::ThreadMailbox m_mailbox;
    JobQueue m_queue;
    std::atomic<quint64> m_strokesBegun = 0;
    mutable std::mutex m_mutex; ///< guards the next three
    std::optional<Source> m_openSource;
    bool m_isHeld = false;
    WorkerStats m_stats;

    // The mesh thread's own.
    std::shared_ptr<core::Sculptor> m_sculptor;
    std::array<std::shared_ptr<PatchInbox>, sourceCount> m_inboxes;
    StrokeReport m_report;
    quint64 m_fusionsBefore = 0; ///< the stroke
    BeginStroke m_stroke;        ///< in work
    bool m_isQuiet = false;      ///< hidePatches()
    /// What its samples do. Undecided: a pull or a sphere, says the first.
    enum class Course { Open, Undecided, Over } m_course = Course::Open;
    std::shared_ptr<core::Journal> m_journal;
    std::vector<core::StrokeSample> m_samples; ///< of the stroke in work, for who keeps records
    core::Box m_box;
    core::Box m_scannedBox;
    double m_area = 0;
    double m_scannedArea = 0;
    std::uint64_t m_scanGeneration = 0; ///< a scan of an older one stops
    quint64 m_epoch = 0;
    std::int64_t m_sampledNs = 0; ///< of the sample in work
    std::int64_t m_flushedNs = 0;

    std::thread m_thread; ///< last: it uses the others
};
} // namespace app
