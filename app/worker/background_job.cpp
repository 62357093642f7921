#include "app/worker/background_job.h"

#include <memory>
#include <utility>

namespace app
{
namespace
{
constexpr int progressSteps = 100;
} // namespace

void LongWork::begin(const QString& what)
{
    m_isBusy = true;
    Q_EMIT busy(what);
}

core::JobControl LongWork::beginStoppable(const QString& what)
{
    begin(what);
    Q_EMIT stoppable(true);
    m_stop = std::stop_source();
    const auto told = std::make_shared<int>(-1);
    const auto progress = [this, told](double share) {
        const int step = static_cast<int>(share * progressSteps);
        if (std::exchange(*told, step) != step)
            m_mail.post([this, share] { Q_EMIT progressed(share); });
    };
    return {m_stop.get_token(), progress};
}

void LongWork::rename(const QString& what)
{
    m_mail.post([this, what] { Q_EMIT busy(what); });
}

void LongWork::keep()
{
    m_stop = std::stop_source(std::nostopstate);
    Q_EMIT stoppable(false);
}

void LongWork::end()
{
    m_isBusy = false;
    Q_EMIT idle();
}

void LongWork::stop()
{
    m_stop.request_stop();
    Q_EMIT stoppable(false);
}
} // namespace app
