#include "headset_inquiry.h"

#include "vr/openxr_runtime.h"

#include <utility>

namespace app
{
void HeadsetInquiry::ask()
{
    if (std::exchange(m_isAsking, true))
        return;
    m_aside.start([this] {
        const QString sentence = vr::OpenXrRuntime::probe().text;
        const auto tell = [this, sentence] {
            m_isAsking = false;
            Q_EMIT answered(sentence);
        };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
    });
}
} // namespace app
