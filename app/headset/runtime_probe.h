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
    /// Starts a probe. While one runs, another call starts none, and only repeats the message if it takes long.
    void start();

Q_SIGNALS:
    /// Emitted with the result; before it with a message, if the probe takes long.
    void finished(const QString& sentence);

private:
    void reportTimeout();

    std::shared_ptr<QString> m_result; ///< owned by the thread until it has ended
    QTimer m_timer;
    vr::RuntimeThread m_thread; ///< last: its work uses the others
};
} // namespace app
