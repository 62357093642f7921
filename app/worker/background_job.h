#pragma once

#include "core/util/job_control.h"
#include "ui/util/background_thread.h"

#include <QObject>

#include <stop_token>
#include <utility>

namespace app
{
/// The one long job that may run at a time: its name, its progress, its cancellation, and a thread for its background
/// part. Thread: gui, except where stated.
class BackgroundJob : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    bool isBusy() const { return m_isBusy; }

    void begin(const QString& what);
    /// As begin(), for a job that cancel() can end. Returns its progress and cancellation.
    core::JobControl beginCancellable(const QString& what);
    /// Changes the name that is shown. Thread: any.
    void rename(const QString& what);
    /// The job is as good as done: cancel() has no effect any more.
    void commit();
    void end();

    void cancel();
    bool wasCancelled() const { return m_stop.stop_requested(); }

    /// Runs work() on the background thread, then onDone(result) on the gui thread. Thread: any.
    template <class Work, class OnDone> void run(Work work, OnDone onDone)
    {
        m_background.run(std::move(work), std::move(onDone));
    }

Q_SIGNALS:
    void busy(const QString& what);
    void cancellable(bool canStop);
    /// 0 to 1.
    void progressed(double share);
    void idle();

private:
    bool m_isBusy = false;
    std::stop_source m_stop; ///< of the present job
    ui::ThreadMailbox m_mailbox;
    ui::BackgroundThread m_background; ///< last
};
} // namespace app
