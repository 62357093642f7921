#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace core
{
/// Threads that wait for work: a fork and join costs some microseconds, not the tens that starting threads does.
/// Thread-safe.
///
/// Not oneTBB: it has no setting for how long helpers stay awake after their work. With 100 microseconds large dabs
/// take 10 % less time than with helpers that sleep at once.
class WorkerPool
{
public:
    WorkerPool() = default;
    ~WorkerPool();

    /// The process's one pool. It starts its threads, one less than there are cores, when they are first needed.
    static WorkerPool& shared();

    /// Calls `work` on this thread and, at the same time, on up to `helpers` others; returns when all calls have.
    /// `work` must do the whole of it if called once: while another caller has the pool, and inside of `work`, there
    /// are no helpers. `work` must not throw.
    void run(const std::function<void()>& work, std::size_t helpers);

    /// For tests of determinism: threads in all, the caller's included; 0: as many as there are cores. Not while run()
    /// runs.
    void setThreads(std::size_t threads);

private:
    void start(const std::function<void()>& work, std::size_t helpers);
    void stop();
    void serve();
    bool claim();

    std::mutex m_caller; ///< held by the caller that has the pool: it alone writes what follows, but the counts
    const std::function<void()>* m_work = nullptr; ///< read by helpers while they run
    std::size_t m_threadCount = 0;
    std::vector<std::thread> m_threads;
    std::atomic<std::uint32_t> m_wanted{0};  ///< helpers that may still begin
    std::atomic<std::uint32_t> m_running{0}; ///< helpers that have begun, or are about to ask whether they may
    std::atomic<bool> m_stopping{false};
};
} // namespace core
