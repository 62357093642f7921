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
/// A thread for work that calls the headset's program, which may never answer: nobody has to wait for its end. All that the work uses has
/// to belong to the work, for it may outlive everything else. All on the thread that made this one, which has to be the gui's.
class RuntimeThread : public QObject
{
    Q_OBJECT

public:
    using Letter = std::function<void()>;
    /// Any thread; returns at once. The gui thread opens the letter, in the order of posting, unless this has gone by then.
    using Post = std::function<void(Letter letter)>;
    using Work = std::function<void(const Post& post)>;

    /// A program that has not answered by then is taken for one that does not answer.
    static constexpr std::chrono::milliseconds patience = std::chrono::seconds(10);

    using QObject::QObject;
    /// Work that has not ended is left behind: it goes on alone.
    ~RuntimeThread() override;

    /// Only while there is no other work.
    void start(Work work);
    /// Begun, and not yet followed by ended().
    bool isWorking() const { return m_thread.joinable(); }
    /// Blocks until the work has ended, no longer than that. False: it goes on.
    bool waitForEnd(std::chrono::milliseconds longest) const;

    /// Work was left behind. What libraries keep for the whole process may not go while that goes on: the process has to end by
    /// std::_Exit(). Any thread.
    static bool hasLeftWork();

Q_SIGNALS:
    /// The work and all that it held are gone; other work may begin, from here too.
    void ended();

private:
    struct Letters
    {
        std::mutex mutex;      ///< of the next two
        RuntimeThread* reader; ///< null: it has gone
        std::deque<Letter> waiting;
    };

    static void post(Letters& letters, Letter letter);
    Q_INVOKABLE void open();
    void finish();

    std::shared_ptr<Letters> m_letters;
    std::future<void> m_end;
    std::thread m_thread;
};
} // namespace vr
