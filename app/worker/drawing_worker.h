#pragma once

#include "app/worker/patch_inbox.h"

#include "core/drawing/incremental_line_drawing.h"
#include "ui/util/thread_mailbox.h"

#include <QObject>
#include <QString>

#include <condition_variable>
#include <deque>
#include <memory>
#include <thread>

namespace app
{
class SculptWorker;

/// Makes drawings of the model on a thread of its own: for the 2D preview while it can be seen, and for sheets. A
/// viewer of the mesh like others: it is fed by patches, and the mesh thread never waits for it. While changes keep
/// coming, drawings are interim ones whose cost goes with the change; a fine one follows when the strokes pause. While
/// nobody looks it needs no memory and no time. Thread: gui; all functions return at once.
class DrawingWorker : public QObject
{
    Q_OBJECT

public:
    /// The worker must outlive this.
    explicit DrawingWorker(SculptWorker* worker, QObject* parent = nullptr);
    ~DrawingWorker() override;

    /// From a stroke's change of the mesh to the drawing that shows it, ms: the last, 0 if there was none. Any thread.
    double latencyMs() const;

public Q_SLOTS:
    void watch(bool isSeen, bool shaded);
    /// A sheet of the model as it is after what was asked for before. The ending says the format.
    void exportTo(const QString& path, const QString& modelName, bool shaded);

Q_SIGNALS:
    void drawn(std::shared_ptr<const core::LineDrawing> drawing);
    void refused(const QString& sentence);
    void noticed(const QString& sentence);

private:
    struct Request
    {
        QString path, modelName;
        bool shaded = false;
        core::MeshPatch model; ///< whole
    };
    /// State that the mesh thread may still access after this object is destroyed.
    struct SharedState
    {
        std::mutex mutex;
        std::condition_variable wake;
        bool hasPatch = false, hasChanged = false, isStopping = false;
        bool isSeen = false, shaded = false;
        double latencyMs = 0;
        std::int64_t changedNs = 0;        ///< when the oldest patch came that waits
        std::shared_ptr<PatchInbox> inbox; ///< null while nobody looks
        std::deque<Request> requests;
        std::stop_source stop;     ///< of the drawing at hand: what it shows is not wanted any more
        std::stop_source stopFine; ///< of a fine one: there is something newer to be shown
    };

    /// What the gui thread wants drawn.
    struct Assignment
    {
        std::shared_ptr<PatchInbox> inbox;
        bool shaded, hasChanged;
        std::int64_t changedNs;
        std::stop_token stop, stopFine;
    };

    static void onPatch(const std::weak_ptr<SharedState>& weak);
    void run();
    bool wait(std::unique_lock<std::mutex>& lock);
    void draw();
    Assignment takeAssignment();
    void show(std::optional<core::LineDrawing> drawing, bool isFine);
    void write(const Request& request);

    SculptWorker* m_worker;
    ui::ThreadMailbox m_mailbox;
    std::shared_ptr<SharedState> m_shared = std::make_shared<SharedState>();

    // The drawing thread's own.
    std::optional<core::IncrementalLineDrawing> m_incremental; ///< while somebody looks
    std::shared_ptr<PatchInbox> m_inbox;                       ///< whose patches it is made of
    bool m_isFine = true;         ///< the last drawing was, or there is none to be made finer
    std::int64_t m_changedNs = 0; ///< of the oldest change by a stroke that no drawing shows yet

    std::thread m_thread; ///< last: it uses the others
};
} // namespace app
