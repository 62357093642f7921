#include "app/headset/headset.h"

#include "app/headset/headset_settings.h"

#include <utility>

namespace app
{
Headset::Headset(const HeadsetDesk::Program& program, MakeClient makeClient, QObject* parent)
    : QObject(parent)
    , m_makeClient(std::move(makeClient))
    , m_desk(program)
{
    connect(&m_desk, &HeadsetDesk::noticed, this, &Headset::noticed);
    connect(&m_desk, &HeadsetDesk::seen, this, &Headset::seen);
    connect(&m_thread, &vr::HeadsetThread::reported, this, &Headset::take);
}

/// The desk begins first: the model is on its way before the first frame.
void Headset::enter()
{
    if (isStuck())
        Q_EMIT reported(vr::HeadsetReport::ended(vr::HeadsetEnd::StillNotResponding));
    else if (!isIn())
        m_thread.enter(m_makeClient(m_desk.open(), HeadsetSettings().choice()));
}

void Headset::leave()
{
    if (!isIn())
        return;
    m_thread.leave();
    Q_EMIT leaving();
}

void Headset::take(const vr::HeadsetReport& report)
{
    if (report.isEnded())
        m_desk.close();
    Q_EMIT reported(report);
}
} // namespace app
