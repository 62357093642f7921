#pragma once

#include "ui/util/thread_mailbox.h"

#include <condition_variable>
#include <memory>
#include <thread>
#include <type_traits>

namespace ui
{
/// A thread for long jobs, which run one after the other in order. The first job starts it. If it is its owner's last
/// member, jobs may use all other members.
///
/// QtConcurrent is not used because ThreadSanitizer does not see the locks of QThreadPool and QFutureWatcher (see
/// ThreadMailbox). Besides, QThreadPool offers no separate thread for jobs that must run in order.
class BackgroundThread
{
public:
    BackgroundThread() = default;
    /// Waits for all queued jobs; their results are dropped.
    ~BackgroundThread();
    Q_DISABLE_COPY_MOVE(BackgroundThread)

    /// Queues a job. Thread: any.
    void run(std::function<void()> job);
    /// Runs work() on this object's thread, then onDone(result) in the event loop of the thread that created the
    /// object. Thread: any.
    template <class Work, class OnDone> void run(Work work, OnDone onDone)
    {
        run([this, work = std::move(work), onDone = std::move(onDone)]() mutable {
            auto result = std::make_shared<std::invoke_result_t<Work&>>(work());
            m_mail.post(
                [onDone = std::move(onDone), result = std::move(result)]() mutable { onDone(std::move(*result)); });
        });
    }
    /// Discards the jobs that have not started.
    void drop();

private:
    void work();

    ThreadMailbox m_mail;
    std::mutex m_mutex; ///< protects the next three members
    std::condition_variable m_wake;
    std::deque<std::function<void()>> m_jobs;
    bool m_isEnding = false;
    std::thread m_thread;
};
} // namespace ui
