#pragma once

#include <QObject>

#include <deque>
#include <functional>

namespace app
{
class SculptWorker;

/// The order of what is asked of a document. Each request sees the model as everything before it left it: it waits
/// until every stroke begun before has been reported, and while the model is replaced or changed as a whole. Strokes
/// wait for the requests before them. Nobody waits by blocking. Thread: gui.
class DocumentQueue : public QObject
{
    Q_OBJECT

public:
    enum class Pause {
        None,
        Installing, ///< the worker has another model than the undo stack knows
        Changing    ///< the whole model is worked on in another thread
    };

    /// The worker is not owned and must outlive the queue.
    explicit DocumentQueue(SculptWorker* worker);

    /// Runs it after everything requested before. While a stroke is open, it waits for the end of that stroke.
    void enqueue(std::function<void()> run);
    /// Runs a part of a stroke after the requests before it, without waiting for reports.
    void enqueueStroke(std::function<void()> run);
    /// From here to endStroke(), requests wait.
    void beginStroke() { m_isStrokeOpen = true; }
    void endStroke();
    /// The worker has reported one more stroke.
    void countReport() { ++m_reported; }
    /// Runs what does not have to wait any more.
    void run();

    /// Requests wait until the pause is None again and run() is called.
    void setPause(Pause pause) { m_pause = pause; }
    /// Holds the worker. Returns false if another source's stroke is open: then `retry` is enqueued.
    bool hold(std::function<void()> retry);
    /// Calls `tell` once everything posted to the worker before is done and would survive the program.
    void whenRecorded(std::function<void()> done);
    /// Runs `move`, a move along the undo stack, and calls `tell` as whenRecorded() does.
    void move(const std::function<void()>& move, std::function<void()> done);

    bool isStrokeOpen() const { return m_isStrokeOpen; } ///< as the user sees it: perhaps not yet posted
    bool hasUnreported() const;
    bool isMoving() const { return m_moves > 0; }
    bool isPaused(Pause pause) const { return m_pause == pause; }
    /// No request waits, and every stroke has ended and been reported. Document::historyChanged() follows each change
    /// of this.
    bool isSettled() const;

private:
    struct Request
    {
        bool waitsForReports; ///< of all strokes begun before
        std::function<void()> run;
    };

    void onConfirmed();

    SculptWorker* m_worker;
    std::deque<Request> m_requests;
    std::deque<Request> m_afterStroke;               ///< requested while a stroke is open
    std::deque<std::function<void()>> m_unconfirmed; ///< in the order of SculptWorker::confirm()
    quint64 m_reported = 0;                          ///< strokes
    int m_moves = 0;                                 ///< not confirmed yet
    bool m_isStrokeOpen = false;
    Pause m_pause = Pause::None;
};
} // namespace app
