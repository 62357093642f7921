#pragma once

#include "app/document/history_store.h"
#include "app/document/work_timer.h"
#include "app/model/model_history.h"
#include "app/worker/background_job.h"
#include "app/worker/sculpt_worker.h"

#include "core/io/stroke/stroke_file.h"
#include "core/operations/starter_models.h"
#include "ui/model/insert_request.h"
#include "ui/settings/model_info.h"

#include <QUndoStack>

#include <deque>
#include <functional>
#include <optional>

namespace core
{
class JournalFolder;
struct JournalDocument;
struct JournalHistory;
struct RecoveredDocument;
} // namespace core

namespace app
{
class RecoveryStore;
struct SavedFile;
struct LoadedModel;
struct ModelChangeOutcome;
struct ExportRequest;
struct ExportOutcome;
struct ExportedBrush;

/// The model that is open: its name, its history, what may be done with it. Gui thread; what takes long is done
/// elsewhere, and signals say when it is.
///
/// Undo, redo and jumps are done in the order in which they were asked for, among strokes too: they wait until every
/// stroke before them has reported, and strokes after them wait for them. Nobody waits by blocking. A change comes to
/// the undo stack when it is done and would survive the program, and not before that a way along the stack counts as
/// gone: modifiedChanged(), isSettled().
class Document : public QObject
{
    Q_OBJECT

public:
    /// The worker is not owned and must outlive the document.
    explicit Document(SculptWorker* worker, QObject* parent = nullptr);
    /// Stops the worker, whose jobs know the document.
    ~Document() override;

    /// Asked before changes are lost: false keeps the present model, and `proceed` may be called later, when they are
    /// saved.
    using MayDiscard = std::function<bool(const std::function<void()>& proceed)>;
    void setDiscardPrompt(MayDiscard canDiscard);
    /// Asked when a file is about to be written: adds what others than the document know.
    void setCompleteMetadata(std::function<void(core::DocumentMetadata&)> complete);
    bool canDiscard(const std::function<void()>& proceed) const;

    /// What is opened from now on is recorded there, as it changes. The store must outlive the document.
    void keepJournals(RecoveryStore* recoveryStore);
    /// Of the model that is open; null: nothing is recorded.
    const std::shared_ptr<core::Journal>& journal() const { return m_journal; }

    const QString& path() const { return m_modelInfo.path; } ///< empty: it comes from no file
    /// Who had it made knows it by that; null: a file's, or a starter.
    const std::shared_ptr<const void>& mark() const { return m_mark; }
    const ui::ModelInfo& modelInfo() const { return m_modelInfo; }
    bool isModified() const;
    bool isBusy() const { return m_job.isBusy(); }
    /// What takes long and is not of the document may go on there, too: busy(), progressed() and idle() tell of it, and
    /// stop() ends it.
    BackgroundJob* job() { return &m_job; }
    /// Another model is on its way: what is done to the present one now is lost if that comes.
    bool isOpening() const { return m_isLoading; }
    /// Nothing that was asked for waits, every stroke has ended and reported. historyChanged() says when to look again.
    bool isSettled() const;
    /// The one answer for actions, wands and history: there is a step back, and its change is still kept.
    bool canUndo() const;
    bool canRedo() const;
    QString undoText() const; ///< empty if there is none
    QString redoText() const;
    /// Runs it when all that was asked for before is done, and every stroke that began before has been reported.
    void enqueue(std::function<void()> run) { request(std::move(run)); }

    /// The model as all that was asked for before left it.
    struct Present
    {
        std::shared_ptr<const core::TriangleMesh> mesh;
        quint64 hash = 0;
        core::DocumentMetadata metadata;
        int step = 0;
        /// What was done to the model since it was opened; nothing: it is not known.
        std::optional<std::vector<core::FileEntry>> steps;
    };
    /// `keep` puts it somewhere, in a thread of its own, and says whether it is safe there; then it counts as saved.
    /// Nobody sculpts from when it is copied until `done`, which hears the answer, has returned. False: something else
    /// is going on, and nothing is done.
    bool saveExternally(const QString& what, std::function<bool(const Present& present)> keep,
                        std::function<void(bool isKept)> done);
    /// A step of the history that is a stroke.
    struct LastStroke
    {
        StrokeReport report; ///< without its change
        std::shared_ptr<StoredDelta> change;
        int index = 0;
        std::optional<quint64> saving; ///< since that one nothing was changed
    };
    /// The last step, if it is a stroke that was done since the model was opened, and nothing is taken back.
    std::optional<LastStroke> lastStroke() const;
    /// Hears what came of it; nothing: the stroke is not the last step any more, or another hand sculpts.
    using TakeAgain = std::function<void(const std::optional<StrokeReport>& report)>;
    /// Does another stroke in the place of the last, or of what was done in its place already: one step, as before.
    /// Where that changes nothing the step stays taken back. Null, or if it is stopped before it is done: the last
    /// stroke as it was, bit for bit.
    void replaceLastStroke(const LastStroke& last, std::shared_ptr<const core::Stroke> stroke,
                           const std::stop_token& stop, TakeAgain done);

    /// `look` sees the states of the model from the first that is kept to the present, in a thread of its own, `done`
    /// comes when it has; nobody sculpts meanwhile, and the model stays as it is. stop() is told to `look`. False:
    /// something else is going on, and nothing is done.
    using Visit = std::function<void(const ModelHistory& history, const core::JobControl& control)>;
    bool visitHistory(const QString& what, Visit look, std::function<void()> done);

    const QUndoStack& undoStack() const { return m_stack; }
    HistoryStore& history() { return m_history; }

    /// Makes a model that may be sculpted, or says why not; in a thread of its own.
    using Make = std::function<LoadedModel(const core::JobControl& control)>;
    struct Made
    {
        QString what; ///< is going on meanwhile
        Make make;
        std::shared_ptr<const void> mark;
        bool discardsChanges = false; ///< the person knows it
    };
    /// A model that others make: no file's.
    void openMade(const Made& made);

public Q_SLOTS:
    /// In the place of what is being opened just now; after what is being written or changed.
    void open(const QString& path);
    /// The same, but nobody is asked: changes were let go already.
    void openDiscardingChanges(const QString& path);
    /// The same, but a model that is not in order is legalised; it has no file then.
    void openRepaired(const QString& path, const core::RepairOptions& options);
    /// The paper's sphere.
    void openSphere();
    void openStarter(core::Starter starter);
    /// A document that the shelf has an offer of, with its history.
    void recover(quint64 offer, const QString& name);
    /// What its files keep beside the model. No change to be saved by itself.
    void setPalette(std::vector<core::Rgb> palette);
    /// Its file is called so now.
    void setPath(const QString& path);
    /// While it has no file it is called so.
    void setName(const QString& name);
    /// Its file is not there any more: the model is nowhere else.
    void onFileDeleted();
    /// To a file that from now on is the model's own.
    void save(const QString& path);
    /// Beside that path, under the first number after all that are there: a GLB, which from now on is the model's own,
    /// and an STL. No file is overwritten.
    void saveNumbered(const QString& path);
    /// To some other file, with at most so many triangles (0: all), which is read back and judged, perhaps by an
    /// installed slicer, too: changes stay unsaved.
    void exportTo(const QString& path, quint64 maxTriangles = 0, bool slices = false);

    /// To a file that brushes are read from: brushExported(). The model and its own file stay what they are.
    void exportBrush();

    /// Changes the whole model, as one step: worked out aside on a copy, while strokes are refused.
    /// A Reset needs no start.
    void apply(const core::ModelCommand& command);
    void insert(const ui::InsertRequest& insertion);
    /// Ends the opening or the change of the whole model that is going on; everything stays as it is.
    void cancelJob();

    void beginStroke(const core::StrokeSettings& settings);
    void addSample(const core::StrokeSample& sample);
    void endStroke();
    /// A step of its own: a ball, or a word why not.
    void addSphere(const core::StrokeSettings& settings, const core::StrokeSample& sample);

    void undo();
    void redo();
    void goTo(int index);

Q_SIGNALS:
    void opened(const ui::ModelInfo& info);
    void modelInfoChanged(const ui::ModelInfo& info);
    void modifiedChanged(bool modified);
    void historyChanged();
    /// A step was done by hand, which is the last of the history now; undo and redo are none.
    void stepped(const core::FileEntry& entry);
    void saved(const QString& path);
    /// The verdict: one line on the file as it was read back.
    void exported(const QString& path, const QString& verdict);
    void brushExported(const QString& path);
    void refused(const QString& sentence);
    /// A file's model is not in order: openRepaired() may take it.
    void repairable(const QString& path, const QString& problem);
    /// Of the model that comes: what was done to it, step by step.
    void repaired(const QString& name, const QStringList& steps);
    /// The same of a model that was to be inserted, and insert() with InsertRequest::repair.
    void insertionRepairable(const ui::InsertRequest& insertion, const QString& problem);
    void insertedRepaired(const QString& name, const QStringList& steps);
    void noticed(const QString& sentence);
    void busy(const QString& what);
    /// While busy: stop() would end it, or has no effect any more.
    void cancellable(bool canStop);
    /// While busy: 0 to 1.
    void progressed(double share);
    void idle();

private:
    /// What was asked for and has to wait for its turn.
    struct Request
    {
        bool afterReports; ///< of all strokes begun before
        std::function<void()> run;
    };

    struct Choice
    {
        QString what;
        Make make;
        bool discardsChanges = false; ///< the person knows it
    };
    static Choice choiceOf(const QString& path, BackgroundJob& work);
    void openFrom(const Choice& choice);
    void openNext(Choice choice);
    void openWaiting();
    void load(const QString& what, const Make& make);
    void install(std::shared_ptr<LoadedModel> model);
    void giveWorker(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal);
    void restore(const core::RecoveredDocument& recovered);
    void retryRecording();
    void startRecording(const std::shared_ptr<core::JournalFolder>& folder);
    core::JournalDocument forJournal() const;
    core::JournalHistory historyNow() const;
    std::optional<std::vector<core::FileEntry>> recordedSteps() const;
    void describeToJournal();
    void startChange(core::ModelCommand command, const ui::InsertRequest& insertion);
    void finishChange(const core::ModelCommand& command, const ui::InsertRequest& insertion,
                      ModelChangeOutcome outcome);
    void endChange(const core::ModelCommand& command, const ui::InsertRequest& insertion,
                   const ModelChangeOutcome& outcome);
    void whenRecorded(std::function<void()> done);
    void onConfirmed();
    void reportOutcome(const core::ModelCommand& command, const ui::InsertRequest& insertion,
                       const ModelChangeOutcome& outcome);
    using Write = std::function<SavedFile(const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata)>;
    core::DocumentMetadata presentMetadata() const;
    void saveBy(const QString& name, const Write& write);
    void finishSaving(int index, const SavedFile& saved);
    void startHandingOver(const std::function<bool(const Present& present)>& keep,
                          const std::function<void(bool isKept)>& done);
    void finishHandingOver(int index, bool isKept, const std::function<void(bool isKept)>& done);
    void setSaved(int index);
    void startExport(const ExportRequest& order, const core::JobControl& control);
    void finishExport(const QString& path, const ExportOutcome& outcome);
    void finishBrush(const ExportedBrush& brush);
    void takeSaved(const QString& path, int index);
    void moveTo(int index);
    void comeTo(int index);
    void startVisit(const Visit& look, const std::function<void()>& done, const core::JobControl& control);
    void onStrokeReplaced(const StrokeReport& report);
    void request(std::function<void()> run);
    void strokeRequest(std::function<void()> run);
    void runRequests();
    bool hasUnreported() const;
    void onReport(const StrokeReport& report);
    void countWork();
    void takeModel(const MeshFacts& facts);
    void takeFacts(const MeshFacts& facts);
    void loseHistory();
    void notifyStateChanged();

    SculptWorker* m_worker;
    HistoryStore m_history;
    QUndoStack m_stack;
    ui::ModelInfo m_modelInfo;
    std::shared_ptr<const core::Snapshot> m_start; ///< what Reset goes back to
    std::shared_ptr<const void> m_mark;
    MayDiscard m_mayDiscard;
    std::function<void(core::DocumentMetadata&)> m_completeMetadata;
    RecoveryStore* m_recoveryStore = nullptr;
    std::shared_ptr<core::Journal> m_journal;             ///< null: nothing is recorded
    std::shared_ptr<core::RecoveredDocument> m_recovered; ///< of the model that is being installed

    std::deque<Request> m_requests;
    std::deque<Request> m_afterStroke; ///< asked for while a stroke is open
    bool m_strokeOpen = false;         ///< as the person sees it: not yet posted, perhaps
    QString m_lastStep;                ///< the name of the stroke that began last
    quint64 m_reported = 0;            ///< strokes
    /// Of the step that was done last, without its change; none: it was no stroke.
    std::optional<StrokeReport> m_lastReport;
    int m_lastIndex = 0;   ///< and where that stands
    TakeAgain m_takeAgain; ///< while a stroke is done again
    quint64 m_savings = 0;
    WorkTimer m_workTimer;
    std::optional<Choice> m_next; ///< to be opened once what goes on has ended
    bool m_isLoading = false;
    bool m_isDiscardAgreed = false; ///< the changes, by the person, for what is being opened; there are no others since
    bool m_isInstalling = false;    ///< the worker has another model than the undo stack knows
    bool m_isChanging = false;      ///< the whole model, aside
    /// Along the undo stack, whose index is there already, that the mesh thread has to confirm.
    int m_moves = 0;
    std::deque<std::function<void()>> m_unconfirmed;
    bool m_changedBeyondHistory = false;
    bool m_isHistoryWhole = true; ///< its first step was done to the model as it was opened
    bool m_toldModified = false;
    BackgroundJob m_job; ///< last
};
} // namespace app
