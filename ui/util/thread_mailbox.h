#pragma once

#include <QObject>

#include <deque>
#include <functional>
#include <mutex>

namespace ui
{
/// How other threads reach the one that made it: what they post is run there, by its event loop, among its other events
/// in the order of posting. What waits when the mailbox goes is dropped. Letters change hands under a mutex; Qt's queue
/// only rings for each, and carries nothing of ours.
class Mailbox : public QObject
{
    Q_OBJECT

public:
    using Letter = std::function<void()>;

    using QObject::QObject;

    /// Any thread; returns at once.
    void post(Letter letter);

private:
    Q_INVOKABLE void open();

    std::mutex m_mutex;
    std::deque<Letter> m_letters;
};
} // namespace ui
