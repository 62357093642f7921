#pragma once

#include <QObject>
#include <QString>

namespace app
{
class BackgroundJob;

/// The outcome of a report; neither if it was cancelled.
struct ReportOutcome
{
    QString problem; ///< one sentence
    bool isWritten = false;
};

/// Writes class reports for the window, as the document's background job. Thread: gui.
class ReportController : public QObject
{
    Q_OBJECT

public:
    /// Not owned: it must outlive this.
    explicit ReportController(BackgroundJob* job, QObject* parent = nullptr);

public Q_SLOTS:
    /// Writes a report on the models in `folder` to `path`, whose ending gives the format. If it is cancelled, there is
    /// no file.
    void write(const QString& folder, const QString& path);

Q_SIGNALS:
    void noticed(const QString& sentence);
    void refused(const QString& sentence);

private:
    void finish(const QString& path, const ReportOutcome& outcome);

    BackgroundJob* m_job;
};
} // namespace app
