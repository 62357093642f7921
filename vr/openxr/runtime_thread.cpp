#include "vr/openxr/runtime_thread.h"

#include <atomic>
#include <utility>

namespace vr
{
namespace
{
std::atomic<bool> leftWork = false;
} // namespace

RuntimeThread::~RuntimeThread()
{
    if (!isWorking())
        return;
    {
        const std::lock_guard lock(m_letters->mutex);
        m_letters->reader = nullptr;
        m_letters->waiting.clear();
    }
    if (waitForEnd({})) {
        m_thread.join();
    } else {
        leftWork = true;
        m_thread.detach();
    }
}

void RuntimeThread::start(Work work)
{
    m_letters = std::make_shared<Letters>();
    m_letters->reader = this;
    std::promise<void> end;
    m_end = end.get_future();
    m_thread = std::thread([this, letters = m_letters, end = std::move(end), work = std::move(work)]() mutable {
        work([&letters](Letter letter) { post(*letters, std::move(letter)); });
        work = nullptr;
        post(*letters, [this] { finish(); }); // is opened only while we are there
        end.set_value();
    });
}

bool RuntimeThread::waitForEnd(std::chrono::milliseconds longest) const
{
    return !isWorking() || m_end.wait_for(longest) == std::future_status::ready;
}

bool RuntimeThread::hasLeftWork()
{
    return leftWork;
}

void RuntimeThread::post(Letters& letters, Letter letter)
{
    const std::lock_guard lock(letters.mutex);
    if (!letters.reader)
        return;
    letters.waiting.push_back(std::move(letter));
    QMetaObject::invokeMethod(letters.reader, "open", Qt::QueuedConnection); // by name: a functor would lie in Qt's queue
}

/// One, for each has rung.
void RuntimeThread::open()
{
    std::unique_lock lock(m_letters->mutex);
    const Letter letter = std::move(m_letters->waiting.front());
    m_letters->waiting.pop_front();
    lock.unlock();
    letter();
}

/// The thread has nothing more to do.
void RuntimeThread::finish()
{
    m_thread.join();
    Q_EMIT ended();
}
} // namespace vr
