#include "ui/util/thread_mailbox.h"

#include <utility>

namespace ui
{
void Mailbox::post(Letter letter)
{
    {
        const std::lock_guard lock(m_mutex);
        m_letters.push_back(std::move(letter));
    }
    QMetaObject::invokeMethod(this, "open", Qt::QueuedConnection); // by name: a functor would lie in Qt's queue
}

/// One, for each has rung. It may run an event loop, in which others are opened.
void Mailbox::open()
{
    std::unique_lock lock(m_mutex);
    const Letter letter = std::move(m_letters.front());
    m_letters.pop_front();
    lock.unlock();
    letter();
}
} // namespace ui
