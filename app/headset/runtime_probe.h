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
    /// One probe at a time; others are ignored, except for a message if it takes long.
    void start();

Q_SIGNALS:
    /// Emitted once, or twice if it takes long: a message first, then the result.
    void finished(const QString& sentence);

private:
    void reportTimeout();

    std::shared_ptr<QString> m_result; ///< the thread's until it has ended
    QTimer m_timer;
    vr::RuntimeThread m_thread; ///< last
};
} // namespace app
