#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace core
{
/// Threads that wait for work: a fork and join costs some microseconds, not the tens that starting threads does. Thread-safe.
class WorkerPool
{
public:
    WorkerPool() = default;
    ~WorkerPool();

    /// The process's one pool. It starts its threads, one less than there are cores, when they are first needed.
    static WorkerPool& shared();

    /// Calls `work` on this thread and, at the same time, on up to `helpers` others; returns when all calls have. `work` must
    /// do the whole of it if called once: while another caller has the pool, and inside of `work`, there are no helpers.
    /// `work` must not throw.
    void run(const std::function<void()>& work, std::size_t helpers);

    /// For tests of determinism: threads in all, the caller's included; 0: as many as there are cores. Not while run() runs.
    void setThreads(std::size_t threads);

private:
    void start(const std::function<void()>& work, std::size_t helpers);
    void stop();
    void serve();

    std::mutex m_caller; ///< held by the caller that has the pool
    std::mutex m_mutex;  ///< guards what follows; the two counts are read without it, too
    std::condition_variable m_begin, m_end;
    const std::function<void()>* m_work = nullptr;
    std::atomic<std::size_t> m_wanted{0};  ///< helpers that may still begin
    std::atomic<std::size_t> m_running{0}; ///< helpers that have begun and not ended
    std::size_t m_threadCount = 0;
    bool m_stopping = false;
    std::vector<std::thread> m_threads;
};
} // namespace core
