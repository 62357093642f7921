// In turns: what the runtime tells -> what we want -> a frame, or a rest while there are none.
// A frame: wait, begin, wands and head and eyes at the time at which it will be seen, the client, each eye, end.
#include "vr/frame/headset_loop.h"

#include <thread>

namespace vr
{
namespace
{
using namespace std::chrono_literals;

constexpr auto restTime = 50ms;
/// Sessions pass through stages on their way to others: people are told of those that last so long.
constexpr auto passingTime = 500ms;
/// A runtime that was asked to end the session and does not is not waited for any longer.
constexpr auto patience = 3s;
} // namespace

void LeaveBell::ring()
{
    {
        const std::lock_guard lock(m_mutex);
        m_hasRung = true;
    }
    m_wake.notify_all();
}

bool LeaveBell::hasRung() const
{
    const std::lock_guard lock(m_mutex);
    return m_hasRung;
}

void LeaveBell::wait(std::chrono::milliseconds time)
{
    std::unique_lock lock(m_mutex);
    m_wake.wait_for(lock, time, [this] { return m_hasRung; });
}

HeadsetLoop::HeadsetLoop(const Parts& parts)
    : m_parts(parts)
    , m_session(parts.instance, parts.binding)
    , m_actions(parts.instance, m_session.handle())
    , m_spaces(m_session.handle())
    , m_eyes(m_session)
    , m_drawnMs(parts.client.drawCallMs())
{
    for (const QString& refused : m_actions.refusedProfiles())
        qInfo("The OpenXR runtime does not know wands of the kind %s", qPrintable(refused));
}

/// A runtime may take the images' memory away with their handles, so nobody may be drawing on them any more.
HeadsetLoop::~HeadsetLoop()
{
    m_parts.gl.finish();
}

HeadsetEnd HeadsetLoop::run()
{
    for (;;) {
        if (const auto end = takeEvents())
            return *end;
        if (const auto end = leaveIfWanted())
            return *end;
        tellStage();
        m_clock.ends(FramePhase::Events);
        if (m_standing.isRunning)
            makeFrame();
        else
            rest();
    }
}

std::optional<HeadsetEnd> HeadsetLoop::takeEvents()
{
    while (const auto event = m_parts.instance.nextEvent())
        if (const auto end = take(*event))
            return end;
    return {};
}

std::optional<HeadsetEnd> HeadsetLoop::take(const XrEvent& event)
{
    switch (event.type()) {
    case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED: return take(event.as<XrEventDataSessionStateChanged>());
    case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING: return HeadsetEnd::RuntimeDied;
    case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING:
        m_spaces.noteChange(event.as<XrEventDataReferenceSpaceChangePending>());
        return {};
    case XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED: m_areKindsOld = true; return {};
    default: return {};
    }
}

std::optional<HeadsetEnd> HeadsetLoop::take(const XrEventDataSessionStateChanged& event)
{
    if (event.session != m_session.handle())
        return {};
    const SessionStep step = nextStep(m_standing, event.state);
    const bool hadInput = m_standing.hasInput();
    if (step == SessionStep::Begin)
        m_session.begin();
    if (step == SessionStep::End) {
        m_session.end();
        m_parts.client.rest();
    }
    m_standing = afterStep(m_standing, event.state);
    m_areKindsOld = m_areKindsOld || (m_standing.hasInput() && !hadInput);
    if (step == SessionStep::Leave)
        return m_standing.isLeaving ? HeadsetEnd::Left : HeadsetEnd::SentAway;
    if (step == SessionStep::Lost)
        return HeadsetEnd::SessionLost;
    return {};
}

/// A session that runs is asked to end, and goes on until the runtime ends it; one that does not is over at once.
std::optional<HeadsetEnd> HeadsetLoop::leaveIfWanted()
{
    if (m_standing.isLeaving)
        return Clock::now() < m_patience ? std::nullopt : std::optional(HeadsetEnd::Left);
    if (!m_wantsToLeave && !m_parts.bell.hasRung())
        return {};
    if (!m_standing.isRunning)
        return HeadsetEnd::Left;
    m_session.requestExit();
    m_standing.isLeaving = true;
    m_patience = Clock::now() + patience;
    return {};
}

HeadsetStage HeadsetLoop::stage() const
{
    if (m_standing.hasInput())
        return HeadsetStage::Running;
    if (m_standing.isVisible())
        return HeadsetStage::Visible;
    if (m_standing.isRunning)
        return HeadsetStage::Hidden;
    return m_stage == HeadsetStage::Starting ? HeadsetStage::Starting : HeadsetStage::TakenOff;
}

void HeadsetLoop::tellStage()
{
    const auto now = Clock::now();
    if (const HeadsetStage seen = stage(); std::exchange(m_seenStage, seen) != seen)
        m_seenSince = now;
    const bool isPassing = m_seenStage != HeadsetStage::Running && now - m_seenSince < passingTime;
    if (m_seenStage == m_stage || m_standing.isLeaving || isPassing)
        return;
    m_stage = m_seenStage;
    m_parts.tell(m_stage);
}

void HeadsetLoop::rest()
{
    if (m_standing.isLeaving)
        std::this_thread::sleep_for(restTime); // the bell has rung
    else
        m_parts.bell.wait(restTime);
    m_lost = {};
    m_clock.startOver();
}

void HeadsetLoop::makeFrame()
{
    const FrameTime time = m_session.waitFrame();
    const auto begun = Clock::now();
    m_clock.ends(FramePhase::Wait);
    Frame frame(m_session, time);
    const FrameInput input = readInput(time);
    const bool isShown = m_eyes.locate(m_spaces.room(), time.display) && time.shouldRender;
    m_parts.gl.makeCurrent();
    m_clock.ends(FramePhase::Input);
    obey(m_parts.client.frame(input));
    m_clock.ends(FramePhase::Client);
    if (isShown)
        drawEyes();
    frame.show(m_spaces.room(), m_eyes.pictures());
    m_clock.ends(FramePhase::Submit);
    count(time, begun, isShown);
}

FrameInput HeadsetLoop::readInput(const FrameTime& time)
{
    const bool roomMoved = m_spaces.advance(time.display);
    const bool hasFocus = m_standing.hasInput();
    const Wands wands = m_actions.read(m_spaces.room(), time.display, hasFocus);
    if (hasFocus && std::exchange(m_areKindsOld, false))
        m_actions.refreshKinds();
    m_head = m_spaces.head(time.display);
    return {wands, m_head, time.display, hasFocus, roomMoved, m_parts.costs};
}

void HeadsetLoop::obey(const FrameOutput& output)
{
    if (m_standing.hasInput())
        for (const HapticPulse& pulse : output.pulses)
            m_actions.pulse(pulse);
    if (output.recentre && m_head)
        m_spaces.recentre(*m_head);
    m_wantsToLeave = m_wantsToLeave || output.leave;
}

void HeadsetLoop::drawEyes()
{
    for (std::size_t eye = 0; eye < m_eyes.count(); ++eye) {
        m_eyes.draw(eye, [&](const EyeImage& image, const EyeView& view) {
            m_parts.gl.makeCurrent();
            m_clock.ends(FramePhase::Images);
            m_parts.client.draw(eye, image, view);
            m_clock.ends(FramePhase::Draw);
        });
        m_clock.ends(FramePhase::Images);
    }
}

void HeadsetLoop::count(const FrameTime& time, Clock::time_point begun, bool isShown)
{
    FrameCost& cost = m_clock.cost();
    const double drawn = m_parts.client.drawCallMs();
    cost.drawCallMs = drawn - std::exchange(m_drawnMs, drawn);
    cost.workMs = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
    cost.periodMs = static_cast<double>(time.period) / 1e6;
    cost.lost = m_lost.count(time.display, time.period, isShown);
    cost.isShown = isShown;
    m_parts.costs.add(cost);
    m_clock.startOver();
}
} // namespace vr
