#include "vr/frame/headset_thread.h"

#include "vr/frame/headset_loop.h"

#include <QGuiApplication>
#include <QOpenGLContext>

#include <utility>

namespace vr
{
namespace
{
HeadsetEnd endOf(XrResult result)
{
    switch (result) {
    case XR_ERROR_INSTANCE_LOST:
    case XR_ERROR_RUNTIME_UNAVAILABLE:
        return HeadsetEnd::RuntimeLost;
    case XR_ERROR_SESSION_LOST:
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE:
        return HeadsetEnd::SessionLost;
    default:
        return HeadsetEnd::Failed;
    }
}

/// Creates the client, and destroys it even if create() returned false.
class CreatedClient
{
public:
    CreatedClient(FrameClient& client, GlContext& gl)
        : m_client(client)
        , m_gl(gl)
        , m_isCreated(client.create(gl.context()))
    {}
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
    using OnReport = std::function<void(const HeadsetReport& report)>;

    explicit Visit(std::shared_ptr<FrameClient> who) : client(std::move(who)) {}

    // Functions that run on the visit's thread.
    HeadsetReport run(const OnReport& onReport);
    HeadsetReport runWith(const OnReport& onReport);
    HeadsetReport runSession(const Instance& instance, const GlBinding& binding, const OnReport& onReport);

    std::shared_ptr<FrameClient> client;
    std::shared_ptr<FrameTimings> timings = std::make_shared<FrameTimings>();
    QString windowSystem = QGuiApplication::platformName();
    GlContext gl;
    std::stop_source stop;
    HeadsetReport last; ///< last report; valid once the thread has ended
};

HeadsetReport HeadsetThread::Visit::run(const OnReport& onReport)
{
    onReport(HeadsetReport::of(HeadsetStage::Starting, {}));
    try {
        return runWith(onReport);
    } catch (const XrError& error) {
        return HeadsetReport::ended(endOf(error.result()), error.text());
    } catch (const std::exception& error) {
        return HeadsetReport::ended(HeadsetEnd::Failed, QString::fromUtf8(error.what()));
    }
}

/// Sets up the instance, the context, the client and the session. They end in reverse order.
HeadsetReport HeadsetThread::Visit::runWith(const OnReport& onReport)
{
    const Instance instance;
    if (instance.status().state != HeadsetStatus::State::Ready)
        return HeadsetReport::ended(HeadsetEnd::Unavailable, OpenXrRuntime::textOf(instance.status()));
    if (stop.stop_requested())
        return HeadsetReport::ended(HeadsetEnd::Left);
    const auto binding = gl.claim() ? currentGlBinding() : nullptr;
    if (!binding || !instance.has(binding->extension()))
        return HeadsetReport::ended(HeadsetEnd::NoBinding, windowSystem);
    const CreatedClient created(*client, gl);
    if (!created.isCreated())
        return HeadsetReport::ended(HeadsetEnd::CannotRender);
    return runSession(instance, *binding, onReport);
}

/// Runs a session, even if this OpenGL is older than the runtime asks for: some runtimes, such as SteamVR, ask for more
/// than they need. Only a refused session proves that the version is too old.
HeadsetReport HeadsetThread::Visit::runSession(const Instance& instance, const GlBinding& binding,
                                               const OnReport& onReport)
{
    const auto [major, minor] = gl.context().format().version();
    const QVersionNumber asked = minOpenGl(instance), present(major, minor);
    const bool isTooOld = present < asked;
    if (isTooOld)
        qInfo("The OpenXR runtime asks for OpenGL %s; the context has %s", qPrintable(asked.toString()),
              qPrintable(present.toString()));
    const auto reportStage = [&](HeadsetStage stage) { onReport(HeadsetReport::of(stage, instance.status().headset)); };
    try {
        HeadsetLoop loop({instance, binding, gl, *client, *timings, stop.get_token(), reportStage});
        return HeadsetReport::ended(loop.run());
    } catch (const XrError& error) {
        if (!isTooOld || error.result() != XR_ERROR_GRAPHICS_DEVICE_INVALID)
            throw;
        const QString text = OpenXrRuntime::openGlRefusal(instance.status().runtime, asked, present);
        return HeadsetReport::ended(HeadsetEnd::Unavailable, text);
    }
}

HeadsetThread::HeadsetThread(std::chrono::milliseconds exitTimeout, QObject* parent)
    : QObject(parent)
    , m_timings(std::make_shared<FrameTimings>())
{
    m_exitTimer.setSingleShot(true);
    m_exitTimer.setInterval(exitTimeout);
    connect(&m_exitTimer, &QTimer::timeout, this, &HeadsetThread::abandon);
    connect(&m_thread, &RuntimeThread::ended, this, &HeadsetThread::finish);
}

HeadsetThread::~HeadsetThread()
{
    leave();
    m_thread.waitForEnd(m_exitTimer.remainingTimeAsDuration());
}

bool HeadsetThread::enter(std::shared_ptr<FrameClient> client)
{
    if (m_visit)
        return false;
    m_visit = std::make_shared<Visit>(std::move(client));
    m_timings = m_visit->timings;
    m_isLeaving = false;
    m_isAbandoned = false;
    m_thread.start([this, visit = m_visit](const RuntimeThread::Post& post) {
        const auto onReport = [&](const HeadsetReport& report) {
            post([this, report] { handleReport(report); });
        }; // only tasks on the gui thread use `this`
        visit->last = visit->run(onReport);
        visit->gl.destroy();
    });
    return true;
}

void HeadsetThread::leave()
{
    if (!m_visit || std::exchange(m_isLeaving, true))
        return;
    m_visit->stop.request_stop();
    m_exitTimer.start();
}

void HeadsetThread::handleReport(const HeadsetReport& report)
{
    if (!m_isLeaving)
        Q_EMIT reported(report);
}

void HeadsetThread::abandon()
{
    if (m_thread.waitForEnd({})) // the visit has ended in time, and finish() is queued already
        return;
    m_isAbandoned = true;
    Q_EMIT reported(HeadsetReport::ended(HeadsetEnd::NotResponding));
}

void HeadsetThread::finish()
{
    m_exitTimer.stop();
    const HeadsetReport last = m_visit->last;
    m_visit.reset();
    if (!m_isAbandoned)
        Q_EMIT reported(last);
}
} // namespace vr
