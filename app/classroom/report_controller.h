#pragma once

#include <QObject>
#include <QString>

namespace app
{
class LongWork;

/// What became of a report: neither if it was stopped.
struct ReportOutcome
{
    QString problem; ///< one sentence
    bool isWritten = false;
};

/// Class reports at the window, aside as its long work. Gui thread.
class ReportDesk : public QObject
{
    Q_OBJECT

public:
    /// Not owned: it must outlive this.
    explicit ReportDesk(LongWork* work, QObject* parent = nullptr);

public Q_SLOTS:
    /// Of the models in `folder`, to `path`, whose ending says the format. Who stops it has no file.
    void write(const QString& folder, const QString& path);

Q_SIGNALS:
    void noticed(const QString& sentence);
    void refused(const QString& sentence);

private:
    void finish(const QString& path, const ReportOutcome& outcome);

    LongWork* m_work;
};
} // namespace app
