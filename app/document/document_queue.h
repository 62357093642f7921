#pragma once

#include <QObject>

#include <deque>
#include <functional>

namespace app
{
class SculptWorker;

/// Orders the requests to a document. A request waits until all earlier strokes are reported, and while the whole model
/// is replaced or changed. Strokes wait for earlier requests. No function blocks. Thread: gui.
class DocumentQueue : public QObject
{
    Q_OBJECT

public:
    enum class Pause {
        None,
        Installing, ///< the worker has a new model, and the undo stack still describes the old one
        Changing    ///< another thread is changing the whole model, or the mesh shows a preview of a change
    };

    /// The worker is not owned and must outlive the queue.
    explicit DocumentQueue(SculptWorker* worker);

    /// Queues a request after all earlier ones. While a stroke is open, the request waits for its end.
    void enqueue(std::function<void()> run);
    /// Queues a part of a stroke after all earlier requests. It does not wait for the reports of strokes.
    void enqueueStroke(std::function<void()> run);
    /// Marks a stroke as open: requests wait until endStroke().
    void beginStroke() { m_isStrokeOpen = true; }
    void endStroke();
    /// Counts a stroke reported by the worker.
    void countReport() { ++m_reported; }
    /// Runs the requests that no longer have to wait.
    void run();

    /// Sets the pause. Requests wait until it is None again and run() is called.
    void setPause(Pause pause) { m_pause = pause; }
    /// Makes the worker refuse strokes. Returns false if another source's stroke is open, and enqueues `retry`.
    bool hold(std::function<void()> retry);
    /// Calls `done` once everything posted to the worker before is done and recorded, so that it would survive a crash.
    void whenRecorded(std::function<void()> done);
    /// Runs `move`, which moves along the undo stack. Calls `done` once the move is recorded.
    void move(const std::function<void()>& move, std::function<void()> done);

    /// Returns whether the user's stroke is open. The worker may not have begun it yet.
    bool isStrokeOpen() const { return m_isStrokeOpen; }
    bool hasUnreported() const;
    bool isMoving() const { return m_moves > 0; }
    bool isPaused(Pause pause) const { return m_pause == pause; }
    /// Returns whether no request waits, every stroke has ended and been reported, every move is confirmed, and the
    /// whole model is not being changed. Document::historyChanged() follows each change of this value.
    bool isSettled() const;

private:
    struct Request
    {
        bool waitsForReports; ///< whether the request waits until all earlier strokes are reported
        std::function<void()> run;
    };

    void onConfirmed();

    SculptWorker* m_worker;
    std::deque<Request> m_requests;
    std::deque<Request> m_afterStroke;               ///< requests made while a stroke is open
    std::deque<std::function<void()>> m_unconfirmed; ///< callbacks in the order of the calls of SculptWorker::confirm()
    quint64 m_reported = 0;                          ///< number of strokes reported
    int m_moves = 0;                                 ///< number of moves not confirmed yet
    bool m_isStrokeOpen = false;
    Pause m_pause = Pause::None;
};
} // namespace app
