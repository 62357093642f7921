#include "headset_thread.h"

#include "headset_loop.h"

#include <QGuiApplication>

#include <utility>

namespace vr
{
namespace
{
HeadsetEnd endOf(XrResult result)
{
    switch (result) {
    case XR_ERROR_INSTANCE_LOST:
    case XR_ERROR_RUNTIME_UNAVAILABLE: return HeadsetEnd::RuntimeDied;
    case XR_ERROR_SESSION_LOST:
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE: return HeadsetEnd::SessionLost;
    default: return HeadsetEnd::Failed;
    }
}

/// Takes leave of the client whatever happens.
class CreatedClient
{
public:
    CreatedClient(FrameClient& client, GlContext& gl) : m_client(client), m_gl(gl), m_isCreated(client.create(gl.context())) {}
    ~CreatedClient()
    {
        m_gl.makeCurrent();
        m_client.destroy();
    }
    CreatedClient(const CreatedClient&) = delete;
    CreatedClient& operator=(const CreatedClient&) = delete;

    bool isCreated() const { return m_isCreated; }

private:
    FrameClient& m_client;
    GlContext& m_gl;
    bool m_isCreated;
};
} // namespace

struct HeadsetThread::Visit
{
    explicit Visit(std::shared_ptr<FrameClient> who) : client(std::move(who)) {}

    std::shared_ptr<FrameClient> client;
    std::shared_ptr<FrameCosts> costs = std::make_shared<FrameCosts>();
    QString windowSystem = QGuiApplication::platformName();
    GlContext gl;
    LeaveBell bell;
};

HeadsetThread::HeadsetThread(QObject* parent) : QObject(parent), m_costs(std::make_shared<FrameCosts>()) {}

HeadsetThread::~HeadsetThread()
{
    leave();
    if (m_thread.joinable())
        m_thread.join();
}

bool HeadsetThread::enter(std::shared_ptr<FrameClient> client)
{
    if (m_visit)
        return false;
    m_visit = std::make_unique<Visit>(std::move(client));
    m_costs = m_visit->costs;
    m_thread = std::thread([this, visit = m_visit.get()] {
        const HeadsetReport last = run(*visit);
        visit->gl.destroy();
        post(last);
    });
    return true;
}

void HeadsetThread::leave()
{
    if (m_visit)
        m_visit->bell.ring();
}

HeadsetReport HeadsetThread::run(Visit& visit)
{
    post(HeadsetReport::of(HeadsetStage::Starting, {}));
    try {
        return runWith(visit);
    } catch (const XrError& error) {
        return HeadsetReport::ended(endOf(error.result()), error.text());
    } catch (const std::exception& error) {
        return HeadsetReport::ended(HeadsetEnd::Failed, QString::fromUtf8(error.what()));
    }
}

/// Instance, context, client, session; they end in the opposite order.
HeadsetReport HeadsetThread::runWith(Visit& visit)
{
    const Instance instance;
    if (instance.status().state != HeadsetStatus::State::Ready)
        return HeadsetReport::ended(HeadsetEnd::NotThere, OpenXrRuntime::textOf(instance.status()));
    if (visit.bell.hasRung())
        return HeadsetReport::ended(HeadsetEnd::Left);
    const auto binding = visit.gl.take() ? currentGlBinding() : nullptr;
    if (!binding || !instance.has(binding->extension()))
        return HeadsetReport::ended(HeadsetEnd::NoBinding, visit.windowSystem);
    const CreatedClient created(*visit.client, visit.gl);
    if (!created.isCreated())
        return HeadsetReport::ended(HeadsetEnd::NoPicture);
    const auto tell = [&](HeadsetStage stage) { post(HeadsetReport::of(stage, instance.status().headset)); };
    HeadsetLoop loop({instance, *binding, visit.gl, *visit.client, *visit.costs, visit.bell, tell});
    return HeadsetReport::ended(loop.run());
}

void HeadsetThread::post(const HeadsetReport& report)
{
    {
        const std::lock_guard lock(m_mutex);
        m_reports.push_back(report);
    }
    QMetaObject::invokeMethod(this, "open", Qt::QueuedConnection); // by name: a functor would lie in Qt's queue
}

/// One, for each has rung. The last comes when the thread has nothing more to do.
void HeadsetThread::open()
{
    std::unique_lock lock(m_mutex);
    const HeadsetReport report = std::move(m_reports.front());
    m_reports.pop_front();
    lock.unlock();
    if (report.isEnded()) {
        m_thread.join();
        m_visit.reset();
    }
    Q_EMIT reported(report);
}
} // namespace vr
