#include "core/util/worker_pool.h"

#include <algorithm>
#include <chrono>

namespace core
{
namespace
{
/// Time for which threads spin before they sleep. A dab usually submits its next work within this time, and waking a
/// thread costs about as much as the work itself.
constexpr std::chrono::microseconds staysAwake(300);

thread_local bool insideOfWork = false;

/// Spins until the condition is true, for at most `staysAwake`.
template <typename Condition> void waitAwake(Condition isSo)
{
    const auto end = std::chrono::steady_clock::now() + staysAwake;
    while (!isSo() && std::chrono::steady_clock::now() < end)
        std::this_thread::yield();
}
} // namespace

WorkerPool& WorkerPool::shared()
{
    static auto* const pool =
        new WorkerPool; // never destroyed: threads that outlive main() may still use it while exit() runs
    return *pool;
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
    m_wanted = 0;
    waitAwake([this] { return m_running == 0; });
    sleepUntil(m_workEnds, [this] { return m_running == 0; });
    m_work = nullptr;
}

/// Gives the work to helpers and wakes them. Starts the threads on first use.
void WorkerPool::start(const std::function<void()>& work, std::size_t helpers)
{
    if (m_threadCount == 0)
        m_threadCount = std::max(1u, std::thread::hardware_concurrency());
    while (m_threads.size() + 1 < m_threadCount)
        m_threads.emplace_back([this] { serve(); });
    m_work = &work;
    m_wanted = static_cast<std::uint32_t>(std::min(helpers, m_threads.size()));
    wake(m_workBegins);
}

void WorkerPool::stop()
{
    m_stopping = true;
    wake(m_workBegins);
    for (std::thread& thread : m_threads)
        thread.join();
    m_threads.clear();
    m_stopping = false;
}

void WorkerPool::serve()
{
    insideOfWork = true;
    const auto isCalled = [this] { return m_wanted > 0 || m_stopping; };
    while (!m_stopping) {
        waitAwake(isCalled);
        sleepUntil(m_workBegins, isCalled);
        ++m_running; // counted before m_wanted is checked, so that run() never misses a helper that is about to begin
        if (claim())
            (*m_work)();
        if (--m_running == 0)
            wake(m_workEnds);
    }
}

/// Takes one of the wanted helper places for this thread. Returns false if none is left.
bool WorkerPool::claim()
{
    std::uint32_t wanted = m_wanted;
    while (wanted > 0 && !m_wanted.compare_exchange_weak(wanted, wanted - 1)) {
    }
    return wanted > 0;
}

/// Sleeps until the condition is true. Whoever makes it true calls wake() afterwards.
template <typename Condition> void WorkerPool::sleepUntil(std::condition_variable& event, Condition isSo)
{
    if (isSo())
        return;
    std::unique_lock sleep(m_sleep);
    ++m_sleepers; // counted before the condition is checked, so that wake() never misses a thread that will sleep
    event.wait(sleep, isSo);
    --m_sleepers;
}

void WorkerPool::wake(std::condition_variable& event)
{
    if (m_sleepers == 0)
        return;
    {
        const std::lock_guard sleep(m_sleep); // a thread that has just checked its condition holds it until it sleeps
    }
    event.notify_all();
}
} // namespace core
