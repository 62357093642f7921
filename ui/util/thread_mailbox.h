#pragma once

#include <QObject>

#include <deque>
#include <functional>
#include <mutex>

namespace ui
{
/// Runs tasks from other threads in the event loop of the thread that created the mailbox, in the order of posting,
/// among its other events. Tasks still waiting at destruction are discarded.
///
/// QMetaObject::invokeMethod() alone would suffice, but Qt is not built for ThreadSanitizer, which cannot see the locks
/// of Qt's event queue and would report all data that a closure carries. Here tasks change threads under a std::mutex,
/// which ThreadSanitizer sees. Qt's queue carries only the wake-up.
class ThreadMailbox : public QObject
{
    Q_OBJECT

public:
    using Task = std::function<void()>;

    using QObject::QObject;

    /// Queues a task and returns at once. Thread: any.
    void post(Task task);

private:
    Q_INVOKABLE void open();

    std::mutex m_mutex;
    std::deque<Task> m_tasks;
};
} // namespace ui
