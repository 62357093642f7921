#include "ui/util/thread_mailbox.h"

#include <utility>

namespace ui
{
void ThreadMailbox::post(Task task)
{
    {
        const std::lock_guard lock(m_mutex);
        m_tasks.push_back(std::move(task));
    }
    // called by name, because a functor would be stored in Qt's queue
    QMetaObject::invokeMethod(this, "open", Qt::QueuedConnection);
}

/// Runs one task: every post() queues one call. The task may run a nested event loop, which then runs later tasks.
void ThreadMailbox::open()
{
    std::unique_lock lock(m_mutex);
    const Task task = std::move(m_tasks.front());
    m_tasks.pop_front();
    lock.unlock();
    task();
}
} // namespace ui
