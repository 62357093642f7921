#pragma once

#include "ui/util/thread_mailbox.h"

#include <condition_variable>
#include <memory>
#include <thread>
#include <type_traits>

namespace ui
{
/// A thread for what takes long, from the first job on: one job after the other, in order. As the last member of its
/// owner it may use all others.
class SideThread
{
public:
    SideThread() = default;
    /// All that was asked for is done before; what came of it is dropped.
    ~SideThread();
    Q_DISABLE_COPY_MOVE(SideThread)

    /// Any thread.
    void run(std::function<void()> job);
    /// take(work()): the work is done on this thread, and taken by the event loop of the one that made this. Any
    /// thread.
    template <class Work, class Take> void run(Work work, Take take)
    {
        run([this, work = std::move(work), take = std::move(take)]() mutable {
            auto made = std::make_shared<std::invoke_result_t<Work&>>(work());
            m_mail.post([take = std::move(take), made = std::move(made)]() mutable { take(std::move(*made)); });
        });
    }
    /// Jobs that have not begun are not done.
    void drop();

private:
    void work();

    Mailbox m_mail;
    std::mutex m_mutex; ///< of the next three
    std::condition_variable m_wake;
    std::deque<std::function<void()>> m_jobs;
    bool m_isEnding = false;
    std::thread m_thread;
};
} // namespace ui
