#include "app/worker/background_job.h"

#include <memory>
#include <utility>

namespace app
{
namespace
{
constexpr int progressSteps = 100;
} // namespace

void BackgroundJob::begin(const QString& what)
{
    m_isBusy = true;
    m_stop = std::stop_source(std::nostopstate); // forgets that an earlier job was cancelled
    Q_EMIT busy(what);
}

core::JobControl BackgroundJob::beginCancellable(const QString& what)
{
    begin(what);
    Q_EMIT cancellable(true);
    m_stop = std::stop_source();
    const auto lastStep = std::make_shared<int>(-1);
    const auto progress = [this, lastStep](double share) {
        const int step = static_cast<int>(share * progressSteps);
        if (std::exchange(*lastStep, step) != step)
            m_mailbox.post([this, share] { Q_EMIT progressed(share); });
    };
    return {m_stop.get_token(), progress};
}

void BackgroundJob::rename(const QString& what)
{
    m_mailbox.post([this, what] { Q_EMIT busy(what); });
}

void BackgroundJob::commit()
{
    m_stop = std::stop_source(std::nostopstate);
    Q_EMIT cancellable(false);
}

void BackgroundJob::end()
{
    m_isBusy = false;
    Q_EMIT idle();
}

void BackgroundJob::cancel()
{
    m_stop.request_stop();
    Q_EMIT cancellable(false);
}
} // namespace app
