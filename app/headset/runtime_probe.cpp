#include "app/headset/runtime_probe.h"

#include "vr/openxr/openxr_runtime.h"

namespace app
{
HeadsetInquiry::HeadsetInquiry(QObject* parent) : QObject(parent)
{
    m_patience.setSingleShot(true);
    m_patience.setInterval(vr::RuntimeThread::responseTimeout);
    connect(&m_patience, &QTimer::timeout, this, &HeadsetInquiry::tellOfSilence);
    connect(&m_aside, &vr::RuntimeThread::ended, this, [this] {
        m_patience.stop();
        Q_EMIT answered(*m_answer);
    });
}

void HeadsetInquiry::ask()
{
    if (!m_aside.isWorking()) {
        m_answer = std::make_shared<QString>();
        m_aside.start([answer = m_answer](const auto&) { *answer = vr::OpenXrRuntime::probe().text; });
        m_patience.start();
    } else if (!m_patience.isActive()) {
        tellOfSilence();
    }
}

void HeadsetInquiry::tellOfSilence()
{
    Q_EMIT answered(tr("The headset's program does not answer. If it is not just starting, start it anew."));
}
} // namespace app
