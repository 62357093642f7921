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

/// Makes line drawings of the model on its own thread: for the visible 2D preview, and for drawing sheets. It receives
/// patches like any viewer, and the mesh thread never waits for it. While changes arrive, it makes interim drawings
/// whose cost depends on the size of the change; a fine drawing follows when strokes pause. While the preview is
/// hidden, it uses no memory and no time. Thread: gui; all functions return at once.
class DrawingWorker : public QObject
{
    Q_OBJECT

public:
    /// The worker must outlive this.
    explicit DrawingWorker(SculptWorker* worker, QObject* parent = nullptr);
    ~DrawingWorker() override;

    /// Returns the time from the last stroke's change of the mesh to the drawing that shows it, ms; 0: no such drawing
    /// yet. Thread: any.
    double latencyMs() const;

public Q_SLOTS:
    void watch(bool isSeen, bool shaded);
    /// Writes a drawing sheet of the model as all earlier requests leave it. The extension of `path` determines the
    /// format.
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
        core::MeshPatch model; ///< the whole mesh
    };
    /// State that the mesh thread may still access after this object is destroyed.
    struct SharedState
    {
        std::mutex mutex;
        std::condition_variable wake;
        bool hasPatch = false, hasChanged = false, isStopping = false;
        bool isSeen = false, shaded = false;
        double latencyMs = 0;
        /// time when the oldest waiting patch arrived, ns of the steady clock; 0: none waits
        std::int64_t changedNs = 0;
        std::shared_ptr<PatchInbox> inbox; ///< null while the preview is hidden
        std::deque<Request> requests;
        std::stop_source stop;     ///< cancels the present drawing: the view has changed
        std::stop_source stopFine; ///< cancels a fine drawing: a newer patch is waiting
    };

    /// A snapshot of SharedState for one drawing.
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

    // State of the drawing thread.
    std::optional<core::IncrementalLineDrawing> m_incremental; ///< exists while the preview is visible
    std::shared_ptr<PatchInbox> m_inbox;                       ///< the inbox whose patches m_incremental contains
    bool m_isFine = true; ///< false: the last drawing was interim or cancelled, so a fine one is due
    /// time of the oldest stroke change not shown in a drawing, ns of the steady clock; 0: none
    std::int64_t m_changedNs = 0;

    std::thread m_thread; ///< last member: the thread uses the other members
};
} // namespace app
