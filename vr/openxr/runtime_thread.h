#pragma once

#include <QObject>

#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

namespace vr
{
/// A thread for work that calls the OpenXR runtime, which may never return: nothing has to wait for the work's end. The
/// work must own everything that it uses, because it may outlive all other objects.
///
/// Thread: the gui thread, which also made this object, unless stated otherwise.
class RuntimeThread : public QObject
{
    Q_OBJECT

public:
    using Task = std::function<void()>;
    /// Queues a task and returns at once. The gui thread runs the tasks in the order of posting; tasks left when the
    /// RuntimeThread is destroyed are dropped. Thread: any.
    using Post = std::function<void(Task task)>;
    using Work = std::function<void(const Post& post)>;

    /// A runtime that has not answered after this time counts as not responding.
    static constexpr std::chrono::milliseconds responseTimeout = std::chrono::seconds(10);

    using QObject::QObject;
    /// Abandons work that has not ended: its thread is detached.
    ~RuntimeThread() override;

    /// Starts the work. Precondition: no other work is in progress.
    void start(Work work);
    /// Returns whether work has begun and is not yet followed by ended().
    bool isWorking() const { return m_thread.joinable(); }
    /// Blocks until the work has ended or `timeout` has passed. Returns false if the work goes on.
    bool waitForEnd(std::chrono::milliseconds timeout) const;

    /// Returns whether this process has ever abandoned work. If so, the process must end by std::_Exit(): the detached
    /// thread may still use static objects of libraries. Thread: any.
    static bool hasAbandonedWork();

Q_SIGNALS:
    /// Emitted after the work and everything that it captured are destroyed. Other work may start, even from the slot.
    void ended();

private:
    struct TaskQueue
    {
        std::mutex mutex;        ///< guards the next two members
        RuntimeThread* receiver; ///< null: the RuntimeThread is destroyed
        std::deque<Task> pending;
    };

    static void post(TaskQueue& tasks, Task task);
    Q_INVOKABLE void open();
    void finish();

    std::shared_ptr<TaskQueue> m_tasks;
    std::future<void> m_end;
    std::thread m_thread;
};
} // namespace vr
