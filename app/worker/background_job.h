#pragma once

#include "core/util/job_control.h"
#include "ui/util/background_thread.h"

#include <QObject>

#include <stop_token>
#include <utility>

namespace app
{
/// The long job of the document: its name, progress, cancellation and background thread. Only one job runs at a time.
/// Thread: gui, except where stated.
class BackgroundJob : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    bool isBusy() const { return m_isBusy; }

    void begin(const QString& what);
    /// Begins a job that cancel() can stop. Returns the control for its progress and cancellation.
    core::JobControl beginCancellable(const QString& what);
    /// Changes the displayed name of the job. Thread: any.
    void rename(const QString& what);
    /// Declares the job completed: cancel() has no effect from now on.
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
    /// Progress, 0 to 1.
    void progressed(double share);
    void idle();

private:
    bool m_isBusy = false;
    std::stop_source m_stop; ///< cancels the present job
    ui::ThreadMailbox m_mailbox;
    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
