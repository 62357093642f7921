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
/// A thread for work that calls the headset's program, which may never answer: nobody has to wait for its end. All that
/// the work uses has to belong to the work, for it may outlive everything else. All on the thread that made this one,
/// which has to be the gui's.
class RuntimeThread : public QObject
{
    Q_OBJECT

public:
    using Task = std::function<void()>;
    /// Any thread; returns at once. The gui thread runs the tasks in the order of posting, unless this object is gone
    /// by then.
    using Post = std::function<void(Task task)>;
    using Work = std::function<void(const Post& post)>;

    /// A program that has not answered by then is taken for one that does not answer.
    static constexpr std::chrono::milliseconds responseTimeout = std::chrono::seconds(10);

    using QObject::QObject;
    /// Work that has not ended is abandoned: its thread is detached.
    ~RuntimeThread() override;

    /// Only while there is no other work.
    void start(Work work);
    /// Begun, and not yet followed by ended().
    bool isWorking() const { return m_thread.joinable(); }
    /// Blocks until the work has ended, no longer than that. False: it goes on.
    bool waitForEnd(std::chrono::milliseconds timeout) const;

    /// Work was abandoned. What libraries keep for the whole process may not go while that goes on: the process has to
    /// end by std::_Exit(). Any thread.
    static bool hasAbandonedWork();

Q_SIGNALS:
    /// The work and all that it held are gone; other work may begin, from here too.
    void ended();

private:
    struct TaskQueue
    {
        std::mutex mutex;        ///< of the next two
        RuntimeThread* receiver; ///< null: it has gone
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
