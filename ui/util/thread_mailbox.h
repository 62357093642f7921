#pragma once

#include <QObject>

#include <deque>
#include <functional>
#include <mutex>

namespace ui
{
/// How other threads reach the one that made it: what they post is run there, by its event loop, among its other events
/// in the order of posting. What waits when the mailbox goes is dropped.
///
/// QMetaObject::invokeMethod() would do, but Qt is not built for ThreadSanitizer, which cannot see the locks of Qt's
/// event queue and would report all that a closure carries. Here tasks change threads under a mutex that it sees; Qt's
/// queue carries only the wake-up.
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
