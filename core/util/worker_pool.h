#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace core
{
/// A pool of threads that wait for work. Starting work on them and waiting for its end takes some microseconds;
/// starting new threads takes tens. Thread: any.
///
/// oneTBB is not used because it cannot set how long helpers stay awake after their work. Large dabs took 10 % less
/// time with helpers that stay awake for 100 microseconds than with helpers that sleep at once.
class WorkerPool
{
public:
    WorkerPool() = default;
    ~WorkerPool();

    /// Returns the process's only pool. Its threads, one fewer than there are cores, start when they are first needed.
    static WorkerPool& shared();

    /// Calls `work` on this thread and at the same time on up to `helpers` others. Returns when all calls have
    /// returned. Precondition: a single call of `work` does all of the work, because there are no helpers while another
    /// caller uses the pool, or in a nested run(). `work` must not throw.
    void run(const std::function<void()>& work, std::size_t helpers);

    /// Sets the number of threads including the caller's, for tests of determinism; 0: as many as cores. Must not be
    /// called during run().
    void setThreads(std::size_t threads);

private:
    void start(const std::function<void()>& work, std::size_t helpers);
    void stop();
    void serve();
    bool claim();
    template <typename Condition> void sleepUntil(std::condition_variable& event, Condition isSo);
    void wake(std::condition_variable& event);

    /// Locked by the caller that uses the pool. Only that caller writes the members below, except m_wanted, m_running
    /// and m_sleepers.
    std::mutex m_caller;
    const std::function<void()>* m_work = nullptr; ///< read by helpers while they run
    std::size_t m_threadCount = 0;
    std::vector<std::thread> m_threads;
    std::atomic<std::uint32_t> m_wanted{0};  ///< number of helpers that may still begin
    std::atomic<std::uint32_t> m_running{0}; ///< number of helpers that have begun, or are about to check m_wanted
    std::atomic<bool> m_stopping{false};
    /// Locked to sleep and to wake. Not std::atomic::wait(), which GCC 12 lets miss a notification where the system has
    /// no futexes, as on Windows.
    std::mutex m_sleep;
    std::atomic<std::uint32_t> m_sleepers{0}; ///< number of threads that sleep, or are about to check whether to
    std::condition_variable m_workBegins, m_workEnds; ///< m_wanted is above 0, or m_stopping; m_running is 0
};
} // namespace core
