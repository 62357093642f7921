#include "long_work.h"

#include <memory>
#include <utility>

namespace app
{
namespace
{
constexpr int progressSteps = 100;
} // namespace

LongWork::LongWork(QObject* parent) : QObject(parent)
{
    m_aside.setMaxThreadCount(1);
}

LongWork::~LongWork() = default;

void LongWork::begin(const QString& what)
{
    m_isBusy = true;
    Q_EMIT busy(what);
}

core::JobWatch LongWork::beginStoppable(const QString& what)
{
    begin(what);
    Q_EMIT stoppable(true);
    m_stop = std::stop_source();
    const auto told = std::make_shared<int>(-1);
    const auto progress = [this, told](double share) {
        const int step = static_cast<int>(share * progressSteps);
        if (std::exchange(*told, step) != step)
            QMetaObject::invokeMethod(this, [this, share] { Q_EMIT progressed(share); }, Qt::QueuedConnection);
    };
    return {m_stop.get_token(), progress};
}

void LongWork::rename(const QString& what)
{
    QMetaObject::invokeMethod(this, [this, what] { Q_EMIT busy(what); }, Qt::QueuedConnection);
}

void LongWork::keep()
{
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

void LongWork::run(std::function<void()> job)
{
    m_aside.start(std::move(job));
}

void LongWork::wait()
{
    m_aside.waitForDone();
}
} // namespace app
