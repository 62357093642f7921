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
    /// Starts a probe. During a probe, starts no other one; if the probe takes long, emits its message again.
    void start();

Q_SIGNALS:
    /// Emitted with the result. If the probe takes long, also emitted earlier with a message about that.
    void finished(const QString& sentence);

private:
    void reportTimeout();

    std::shared_ptr<QString> m_result; ///< written by the thread until it has ended
    QTimer m_timer;
    vr::RuntimeThread m_thread; ///< last member: its work uses the other members
};
} // namespace app
