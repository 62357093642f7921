#pragma once

#include "ui/util/thread_mailbox.h"

#include <condition_variable>
#include <memory>
#include <thread>
#include <type_traits>

namespace ui
{
/// A thread for long jobs, started by the first one. Jobs run one after the other, in order. As the last member of its
/// owner it may use all others.
///
/// Not QtConcurrent, for the reason given at the mailbox: ThreadSanitizer does not see the locks of QThreadPool and of
/// QFutureWatcher. Besides, QThreadPool gives no thread of its own to jobs that have to be done in order.
class BackgroundThread
{
public:
    BackgroundThread() = default;
    /// Waits for all queued jobs; their results are dropped.
    ~BackgroundThread();
    Q_DISABLE_COPY_MOVE(BackgroundThread)

    /// Queues a job for this thread. Thread: any.
    void run(std::function<void()> job);
    /// Runs work() on this thread, then onDone(result) in the event loop of the thread that made this object.
    /// Thread: any.
    template <class Work, class OnDone> void run(Work work, OnDone onDone)
    {
        run([this, work = std::move(work), onDone = std::move(onDone)]() mutable {
            auto result = std::make_shared<std::invoke_result_t<Work&>>(work());
            m_mail.post(
                [onDone = std::move(onDone), result = std::move(result)]() mutable { onDone(std::move(*result)); });
        });
    }
    /// Drops the jobs that have not begun.
    void drop();

private:
    void work();

    ThreadMailbox m_mail;
    std::mutex m_mutex; ///< of the next three
    std::condition_variable m_wake;
    std::deque<std::function<void()>> m_jobs;
    bool m_isEnding = false;
    std::thread m_thread;
};
} // namespace ui
