#pragma once

#include <QObject>

#include <deque>
#include <functional>
#include <mutex>

namespace ui
{
/// Runs tasks that other threads post in the thread that made this object: in its event loop, in the order of posting.
/// Tasks still queued at destruction are dropped. The tasks lie in a queue of our own, under a mutex that
/// ThreadSanitizer sees; Qt's queue carries one empty call for each.
class ThreadMailbox : public QObject
{
    Q_OBJECT

public:
    using Task = std::function<void()>;

    using QObject::QObject;

    /// Any thread; returns at once.
    void post(Task task);

private:
    Q_INVOKABLE void open();

    std::mutex m_mutex;
    std::deque<Task> m_tasks;
};
} // namespace ui
