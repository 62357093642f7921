#include "app/headset/headset.h"

#include "app/headset/headset_settings_store.h"

#include <utility>

namespace app
{
Headset::Headset(const HeadsetController::Program& program, MakeClient makeClient, QObject* parent)
    : QObject(parent)
    , m_makeClient(std::move(makeClient))
    , m_controller(program)
{
    connect(&m_controller, &HeadsetController::noticed, this, &Headset::noticed);
    connect(&m_controller, &HeadsetController::avatarChanged, this, &Headset::avatarChanged);
    connect(&m_thread, &vr::HeadsetThread::reported, this, &Headset::onReport);
}

/// Begins a visit. The controller starts first, so that the model is sent before the first frame.
void Headset::enter()
{
    if (isStuck())
        Q_EMIT reported(vr::HeadsetReport::ended(vr::HeadsetEnd::StillNotResponding));
    else if (!isActive())
        m_thread.enter(m_makeClient(m_controller.open(), HeadsetSettingsStore().load()));
}

void Headset::leave()
{
    if (!isActive())
        return;
    m_thread.leave();
    Q_EMIT leaving();
}

void Headset::onReport(const vr::HeadsetReport& report)
{
    if (report.isEnded())
        m_controller.close();
    Q_EMIT reported(report);
}
} // namespace app
