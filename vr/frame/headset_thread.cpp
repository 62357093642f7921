#include "vr/frame/headset_thread.h"

#include "vr/frame/headset_loop.h"

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
    using Tell = std::function<void(const HeadsetReport& report)>;

    explicit Visit(std::shared_ptr<FrameClient> who) : client(std::move(who)) {}

    // The visit's thread.
    HeadsetReport run(const Tell& tell);
    HeadsetReport runWith(const Tell& tell);

    std::shared_ptr<FrameClient> client;
    std::shared_ptr<FrameCosts> costs = std::make_shared<FrameCosts>();
    QString windowSystem = QGuiApplication::platformName();
    GlContext gl;
    LeaveBell bell;
    HeadsetReport last; ///< once the thread has ended
};

HeadsetReport HeadsetThread::Visit::run(const Tell& tell)
{
    tell(HeadsetReport::of(HeadsetStage::Starting, {}));
    try {
        return runWith(tell);
    } catch (const XrError& error) {
        return HeadsetReport::ended(endOf(error.result()), error.text());
    } catch (const std::exception& error) {
        return HeadsetReport::ended(HeadsetEnd::Failed, QString::fromUtf8(error.what()));
    }
}

/// Instance, context, client, session; they end in the opposite order.
HeadsetReport HeadsetThread::Visit::runWith(const Tell& tell)
{
    const Instance instance;
    if (instance.status().state != HeadsetStatus::State::Ready)
        return HeadsetReport::ended(HeadsetEnd::NotThere, OpenXrRuntime::textOf(instance.status()));
    if (bell.hasRung())
        return HeadsetReport::ended(HeadsetEnd::Left);
    const auto binding = gl.take() ? currentGlBinding() : nullptr;
    if (!binding || !instance.has(binding->extension()))
        return HeadsetReport::ended(HeadsetEnd::NoBinding, windowSystem);
    const CreatedClient created(*client, gl);
    if (!created.isCreated())
        return HeadsetReport::ended(HeadsetEnd::NoPicture);
    const auto tellStage = [&](HeadsetStage stage) { tell(HeadsetReport::of(stage, instance.status().headset)); };
    HeadsetLoop loop({instance, *binding, gl, *client, *costs, bell, tellStage});
    return HeadsetReport::ended(loop.run());
}

HeadsetThread::HeadsetThread(std::chrono::milliseconds patience, QObject* parent)
    : QObject(parent)
    , m_costs(std::make_shared<FrameCosts>())
{
    m_patience.setSingleShot(true);
    m_patience.setInterval(patience);
    connect(&m_patience, &QTimer::timeout, this, &HeadsetThread::giveUp);
    connect(&m_thread, &RuntimeThread::ended, this, &HeadsetThread::finish);
}

HeadsetThread::~HeadsetThread()
{
    leave();
    m_thread.waitForEnd(m_patience.remainingTimeAsDuration());
}

bool HeadsetThread::enter(std::shared_ptr<FrameClient> client)
{
    if (m_visit)
        return false;
    m_visit = std::make_shared<Visit>(std::move(client));
    m_costs = m_visit->costs;
    m_isLeaving = false;
    m_isGivenUp = false;
    m_thread.start([this, visit = m_visit](const RuntimeThread::Post& post) {
        const auto tell = [&](const HeadsetReport& report) { post([this, report] { take(report); }); }; // only letters know us
        visit->last = visit->run(tell);
        visit->gl.destroy();
    });
    return true;
}

void HeadsetThread::leave()
{
    if (!m_visit || std::exchange(m_isLeaving, true))
        return;
    m_visit->bell.ring();
    m_patience.start();
}

void HeadsetThread::take(const HeadsetReport& report)
{
    if (!m_isLeaving)
        Q_EMIT reported(report);
}

void HeadsetThread::giveUp()
{
    if (m_thread.waitForEnd({})) // the letter is on its way
        return;
    m_isGivenUp = true;
    Q_EMIT reported(HeadsetReport::ended(HeadsetEnd::NoAnswer));
}

void HeadsetThread::finish()
{
    m_patience.stop();
    const HeadsetReport last = m_visit->last;
    m_visit.reset();
    if (!m_isGivenUp)
        Q_EMIT reported(last);
}
} // namespace vr
