#pragma once

#include <QObject>
#include <QString>

namespace app
{
class BackgroundJob;

/// Result of a report. If cancelled, there is no problem and isWritten is false.
struct ReportOutcome
{
    QString problem; ///< one sentence; empty if there is none
    bool isWritten = false;
};

/// Writes class reports for the window as the document's long job. Thread: gui.
class ReportController : public QObject
{
    Q_OBJECT

public:
    /// Does not own `job`, which must outlive this.
    explicit ReportController(BackgroundJob* job, QObject* parent = nullptr);

public Q_SLOTS:
    /// Writes a report on the models in `folder` to `path`, whose extension determines the format. Cancelling leaves no
    /// file.
    void write(const QString& folder, const QString& path);

Q_SIGNALS:
    void noticed(const QString& sentence);
    void refused(const QString& sentence);

private:
    void finish(const QString& path, const ReportOutcome& outcome);

    BackgroundJob* m_job;
};
} // namespace app
