#include "vr/openxr/runtime_thread.h"

#include <atomic>
#include <utility>

namespace vr
{
namespace
{
std::atomic<bool> abandonedWork = false;
} // namespace

RuntimeThread::~RuntimeThread()
{
    if (!isWorking())
        return;
    {
        const std::lock_guard lock(m_tasks->mutex);
        m_tasks->receiver = nullptr;
        m_tasks->pending.clear();
    }
    if (waitForEnd({})) {
        m_thread.join();
    } else {
        abandonedWork = true;
        m_thread.detach();
    }
}

void RuntimeThread::start(Work work)
{
    m_tasks = std::make_shared<TaskQueue>();
    m_tasks->receiver = this;
    std::promise<void> end;
    m_end = end.get_future();
    m_thread = std::thread([this, tasks = m_tasks, end = std::move(end), work = std::move(work)]() mutable {
        work([&tasks](Task task) { post(*tasks, std::move(task)); });
        work = nullptr;
        post(*tasks, [this] { finish(); }); // runs only while this object exists
        end.set_value();
    });
}

bool RuntimeThread::waitForEnd(std::chrono::milliseconds timeout) const
{
    return !isWorking() || m_end.wait_for(timeout) == std::future_status::ready;
}

bool RuntimeThread::hasAbandonedWork()
{
    return abandonedWork;
}

void RuntimeThread::post(TaskQueue& tasks, Task task)
{
    const std::lock_guard lock(tasks.mutex);
    if (!tasks.receiver)
        return;
    tasks.pending.push_back(std::move(task));
    // Called by name, so that the task stays in `pending`, where the destructor can clear it.
    QMetaObject::invokeMethod(tasks.receiver, "open", Qt::QueuedConnection);
}

/// Runs the oldest task. Every post() queues one call of this function.
void RuntimeThread::open()
{
    std::unique_lock lock(m_tasks->mutex);
    const Task task = std::move(m_tasks->pending.front());
    m_tasks->pending.pop_front();
    lock.unlock();
    task();
}

/// Joins the thread, whose work is done.
void RuntimeThread::finish()
{
    m_thread.join();
    Q_EMIT ended();
}
} // namespace vr
