#pragma once

#include "core/job_watch.h"

#include <QObject>
#include <QThreadPool>

#include <functional>
#include <stop_token>

namespace app
{
/// The one long piece of work that may go on at a time: what it is, how far it is, its end by hand, and a thread for the part
/// of it that nobody else has to do. Gui thread, but where it says otherwise.
class LongWork : public QObject
{
    Q_OBJECT

public:
    explicit LongWork(QObject* parent = nullptr);
    /// Waits for what runs.
    ~LongWork() override;

    bool isBusy() const { return m_isBusy; }

    void begin(const QString& what);
    /// What stop() ends; it hears of both by the watch.
    core::JobWatch beginStoppable(const QString& what);
    /// It is called otherwise now. Any thread.
    void rename(const QString& what);
    /// Once it is as good as done: stop() has no effect any more.
    void keep();
    void end();

    void stop();
    bool wasStopped() const { return m_stop.stop_requested(); }

    /// On the thread aside, after what was run before. Any thread.
    void run(std::function<void()> job);
    void wait();

Q_SIGNALS:
    void busy(const QString& what);
    void stoppable(bool canStop);
    /// 0 to 1.
    void progressed(double share);
    void idle();

private:
    bool m_isBusy = false;
    std::stop_source m_stop; ///< of what goes on
    QThreadPool m_aside;     ///< last, so that its jobs end first
};
} // namespace app
