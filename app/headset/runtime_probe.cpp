#include "app/headset/runtime_probe.h"

#include "vr/openxr/openxr_runtime.h"

namespace app
{
RuntimeProbe::RuntimeProbe(QObject* parent) : QObject(parent)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(vr::RuntimeThread::responseTimeout);
    connect(&m_timer, &QTimer::timeout, this, &RuntimeProbe::reportTimeout);
    connect(&m_thread, &vr::RuntimeThread::ended, this, [this] {
        m_timer.stop();
        Q_EMIT finished(*m_result);
    });
}

void RuntimeProbe::start()
{
    if (!m_thread.isWorking()) {
        m_result = std::make_shared<QString>();
        m_thread.start([result = m_result](const auto&) { *result = vr::OpenXrRuntime::probe().text; });
        m_timer.start();
    } else if (!m_timer.isActive()) {
        reportTimeout();
    }
}

void RuntimeProbe::reportTimeout()
{
    Q_EMIT finished(tr("The headset's program does not answer. If it is not just starting, restart it."));
}
} // namespace app
