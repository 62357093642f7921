#include "worker_pool.h"

#include <algorithm>
#include <chrono>

namespace core
{
namespace
{
/// A dab comes back with more work so soon: to sleep and be woken costs about as much as what there is to do.
constexpr std::chrono::microseconds staysAwake(100);

thread_local bool insideOfWork = false;

/// Returns when it is so, or after a while all the same.
template <typename Condition> void waitAwake(Condition isSo)
{
    const auto end = std::chrono::steady_clock::now() + staysAwake;
    while (!isSo() && std::chrono::steady_clock::now() < end)
        std::this_thread::yield();
}
} // namespace

WorkerPool& WorkerPool::shared()
{
    static WorkerPool pool;
    return pool;
}

WorkerPool::~WorkerPool()
{
    stop();
}

void WorkerPool::setThreads(std::size_t threads)
{
    const std::lock_guard caller(m_caller);
    stop();
    m_threadCount = threads;
}

void WorkerPool::run(const std::function<void()>& work, std::size_t helpers)
{
    if (helpers == 0 || insideOfWork)
        return work();
    const std::unique_lock caller(m_caller, std::try_to_lock);
    if (!caller)
        return work();
    start(work, helpers);
    insideOfWork = true;
    work();
    insideOfWork = false;
    {
        const std::lock_guard lock(m_mutex);
        m_wanted = 0;
    }
    waitAwake([this] { return m_running == 0; });
    std::unique_lock lock(m_mutex);
    m_end.wait(lock, [this] { return m_running == 0; });
    m_work = nullptr;
}

/// Lets helpers begin.
void WorkerPool::start(const std::function<void()>& work, std::size_t helpers)
{
    if (m_threadCount == 0)
        m_threadCount = std::max(1u, std::thread::hardware_concurrency());
    while (m_threads.size() + 1 < m_threadCount)
        m_threads.emplace_back([this] { serve(); });
    {
        const std::lock_guard lock(m_mutex);
        m_work = &work;
        m_wanted = std::min(helpers, m_threads.size());
    }
    m_begin.notify_all();
}

void WorkerPool::stop()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stopping = true;
    }
    m_begin.notify_all();
    for (std::thread& thread : m_threads)
        thread.join();
    m_threads.clear();
    m_stopping = false;
}

void WorkerPool::serve()
{
    insideOfWork = true;
    while (true) {
        waitAwake([this] { return m_wanted > 0; });
        std::unique_lock lock(m_mutex);
        m_begin.wait(lock, [this] { return m_stopping || m_wanted > 0; });
        if (m_stopping)
            return;
        --m_wanted;
        ++m_running;
        const std::function<void()>& work = *m_work;
        lock.unlock();
        work();
        lock.lock();
        if (--m_running == 0)
            m_end.notify_one();
    }
}
} // namespace core
