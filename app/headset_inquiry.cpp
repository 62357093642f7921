#include "headset_inquiry.h"

#include "vr/openxr_runtime.h"

#include <utility>

namespace app
{
void HeadsetInquiry::ask()
{
    if (std::exchange(m_isAsking, true))
        return;
    m_aside.run([] { return vr::OpenXrRuntime::probe().text; },
                [this](const QString& sentence) {
                    m_isAsking = false;
                    Q_EMIT answered(sentence);
                });
}
} // namespace app
