#pragma once

#include "core/util/job_control.h"
#include "ui/util/background_thread.h"

#include <QObject>

#include <stop_token>
#include <utility>

namespace app
{
/// The one long piece of work that may go on at a time: what it is, how far it is, its end by hand, and a thread for
/// the part of it that nobody else has to do. Gui thread, but where it says otherwise.
class LongWork : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    bool isBusy() const { return m_isBusy; }

    void begin(const QString& what);
    /// What stop() ends; it hears of both by the watch.
    core::JobControl beginStoppable(const QString& what);
    /// It is called otherwise now. Any thread.
    void rename(const QString& what);
    /// Once it is as good as done: stop() has no effect any more.
    void keep();
    void end();

    void stop();
    bool wasStopped() const { return m_stop.stop_requested(); }

    /// take(work()): the work is done on the thread aside, and taken by the gui thread. Any thread.
    template <class Work, class Take> void run(Work work, Take take) { m_aside.run(std::move(work), std::move(take)); }

Q_SIGNALS:
    void busy(const QString& what);
    void stoppable(bool canStop);
    /// 0 to 1.
    void progressed(double share);
    void idle();

private:
    bool m_isBusy = false;
    std::stop_source m_stop; ///< of what goes on
    ui::ThreadMailbox m_mail;
    ui::BackgroundThread m_aside; ///< last
};
} // namespace app
