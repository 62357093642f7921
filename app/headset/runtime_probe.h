#pragma once

#include "vr/openxr/runtime_thread.h"

#include <QTimer>

namespace app
{
/// Probes the OpenXR runtime in the background, so that neither the window nor the end of the program waits for it.
/// Thread: gui.
class RuntimeProbe : public QObject
{
    Q_OBJECT

public:
    explicit RuntimeProbe(QObject* parent = nullptr);

public Q_SLOTS:
    /// Starts a probe, unless one is running. If the running one has exceeded its time limit, emits finished() again
    /// with the message that the runtime does not answer.
    void start();

Q_SIGNALS:
    /// Emitted with the result. Emitted earlier too, with a message that the runtime does not answer, if the probe
    /// exceeds its time limit (RuntimeThread::responseTimeout).
    void finished(const QString& sentence);

private:
    void reportTimeout();

    std::shared_ptr<QString> m_result; ///< written by the thread until it has ended
    QTimer m_timer;
    vr::RuntimeThread m_thread; ///< last member: its work uses the other members
};
} // namespace app
