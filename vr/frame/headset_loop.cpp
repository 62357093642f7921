// The loop polls the runtime's events, handles a stop request, then renders a frame, or idles while no frames are
// wanted.
// A frame waits for the runtime, begins, reads wands, head and eyes for its display time, runs the client, draws each
// eye and ends.
#include "vr/frame/headset_loop.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace vr
{
namespace
{
constexpr auto idleTime = std::chrono::milliseconds(50);
/// A stage other than Running is reported only if it lasts at least this long; shorter ones are transitions.
constexpr auto transitionTime = std::chrono::milliseconds(500);
/// Time that the runtime has to end the session after it was asked to.
constexpr auto exitTimeout = std::chrono::seconds(3);

/// Waits until a stop is requested or `time` has passed.
void wait(const std::stop_token& stop, std::chrono::milliseconds time)
{
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any().wait_for(lock, stop, time, [] { return false; });
}
} // namespace

HeadsetLoop::HeadsetLoop(const Parts& parts)
    : m_parts(parts)
    , m_session(parts.instance, parts.binding)
    , m_actions(parts.instance, m_session.handle())
    , m_handTrackers(parts.instance, m_session.handle())
    , m_spaces(parts.instance, m_session.handle())
    , m_views(parts.instance, m_session)
    , m_drawCallMs(parts.client.drawCallMs())
{
    for (const QString& refused : m_actions.refusedProfiles())
        qInfo("The OpenXR runtime does not know wands of the kind %s", qPrintable(refused));
}

/// Waits until all drawing is complete: destroying a swapchain may free the memory of images that are still drawn to.
HeadsetLoop::~HeadsetLoop()
{
    m_parts.gl.finish();
}

HeadsetEnd HeadsetLoop::run()
{
    for (;;) {
        if (const auto end = pollEvents())
            return *end;
        if (const auto end = exitIfRequested())
            return *end;
        reportStage();
        m_clock.endPhase(FramePhase::Events);
        if (m_status.isRunning)
            renderFrame();
        else
            idle();
    }
}

std::optional<HeadsetEnd> HeadsetLoop::pollEvents()
{
    while (const auto event = m_parts.instance.nextEvent())
        if (const auto end = handleEvent(*event))
            return end;
    return {};
}

std::optional<HeadsetEnd> HeadsetLoop::handleEvent(const XrEvent& event)
{
    switch (event.type()) {
    case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED:
        return handleEvent(event.as<XrEventDataSessionStateChanged>());
    case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING:
        return HeadsetEnd::RuntimeLost;
    case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING:
        m_spaces.notePendingChange(event.as<XrEventDataReferenceSpaceChangePending>());
        return {};
    case XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED:
        m_areProfilesStale = true;
        return {};
    case XR_TYPE_EVENT_DATA_EVENTS_LOST: // a lost event may have reported any change, so the state is read again
        qInfo("The OpenXR runtime has lost events");
        m_areProfilesStale = true;
        m_views.hidden().refresh();
        return {};
    case XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR:
        m_views.hidden().handle(event.as<XrEventDataVisibilityMaskChangedKHR>());
        return {};
    default:
        return {};
    }
}

std::optional<HeadsetEnd> HeadsetLoop::handleEvent(const XrEventDataSessionStateChanged& event)
{
    if (event.session != m_session.handle())
        return {};
    const SessionStep step = nextStep(m_status, event.state);
    const bool hadInput = m_status.hasInput();
    if (step == SessionStep::Begin)
        m_session.begin();
    if (step == SessionStep::End) {
        m_session.end();
        m_parts.client.idle();
    }
    m_status = afterStep(m_status, event.state);
    m_areProfilesStale = m_areProfilesStale || (m_status.hasInput() && !hadInput);
    if (step == SessionStep::Exit)
        return m_status.isExiting ? HeadsetEnd::Left : HeadsetEnd::EndedByRuntime;
    if (step == SessionStep::Lost)
        return HeadsetEnd::SessionLost;
    return {};
}

/// Asks a running session to exit; it goes on until the runtime ends it. A session that is not running ends at once.
std::optional<HeadsetEnd> HeadsetLoop::exitIfRequested()
{
    if (m_status.isExiting)
        return Clock::now() < m_exitDeadline ? std::nullopt : std::optional(HeadsetEnd::Left);
    if (!m_exitRequested && !m_parts.stop.stop_requested())
        return {};
    if (!m_status.isRunning)
        return HeadsetEnd::Left;
    m_session.requestExit();
    m_status.isExiting = true;
    m_exitDeadline = Clock::now() + exitTimeout;
    return {};
}

HeadsetStage HeadsetLoop::stage() const
{
    if (m_status.hasInput())
        return HeadsetStage::Running;
    if (m_status.isVisible())
        return HeadsetStage::Visible;
    if (m_status.isRunning)
        return HeadsetStage::Hidden;
    return m_stage == HeadsetStage::Starting ? HeadsetStage::Starting : HeadsetStage::TakenOff;
}

void HeadsetLoop::reportStage()
{
    const auto now = Clock::now();
    if (const HeadsetStage seen = stage(); std::exchange(m_seenStage, seen) != seen)
        m_seenSince = now;
    const bool isTransition = m_seenStage != HeadsetStage::Running && now - m_seenSince < transitionTime;
    if (m_seenStage == m_stage || m_status.isExiting || isTransition)
        return;
    m_stage = m_seenStage;
    m_parts.onStage(m_stage);
}

void HeadsetLoop::idle()
{
    if (m_status.isExiting)
        std::this_thread::sleep_for(idleTime); // wait() would return at once if a stop is requested
    else
        wait(m_parts.stop, idleTime);
    m_dropped = {};
    m_clock.reset();
}

void HeadsetLoop::renderFrame()
{
    const FrameTime time = m_session.waitFrame();
    const auto begun = Clock::now();
    m_clock.endPhase(FramePhase::Wait);
    Frame frame(m_session, time);
    const FrameInput input = readInput(time);
    const bool isShown = m_views.locate(m_spaces.room(), time.display) && time.shouldRender;
    m_parts.gl.makeCurrent();
    m_clock.endPhase(FramePhase::Input);
    handle(m_parts.client.frame(input));
    m_clock.endPhase(FramePhase::Client);
    if (isShown)
        drawViews();
    frame.show(m_spaces.room(), m_views.pictures());
    m_clock.endPhase(FramePhase::Submit);
    count(time, begun, isShown);
}

FrameInput HeadsetLoop::readInput(const FrameTime& time)
{
    const bool roomMoved = m_spaces.advance(time.display);
    const bool hasFocus = m_status.hasInput();
    const Wands wands = m_actions.read(m_spaces.room(), time.display, hasFocus);
    if (hasFocus && std::exchange(m_areProfilesStale, false))
        m_actions.refreshProfiles();
    m_head = m_spaces.head(time.display);
    FrameInput input{wands, m_head, time.display, hasFocus, roomMoved, m_parts.timings, m_session.offersPassthrough()};
    for (const Side side : {Side::Left, Side::Right})
        if (const auto i = static_cast<std::size_t>(side); wands[i].isHand && wands[i].isTracked)
            input.joints[i] = m_handTrackers.locate(side, m_spaces.room(), time.display);
    return input;
}

void HeadsetLoop::handle(const FrameOutput& output)
{
    if (m_status.hasInput())
        for (const HapticPulse& pulse : output.pulses)
            m_actions.pulse(pulse);
    if (output.recentre && m_head)
        m_spaces.recentre(*m_head);
    m_exitRequested = m_exitRequested || output.leave;
    m_session.setPassthrough(output.passthrough);
}

void HeadsetLoop::drawViews()
{
    for (std::size_t eye = 0; eye < m_views.count(); ++eye) {
        m_views.draw(eye, [&](const EyeImage& image, const EyeView& view) {
            m_parts.gl.makeCurrent();
            m_clock.endPhase(FramePhase::Images);
            EyeView seen = view;
            seen.hasPassthrough = m_session.hasPassthrough();
            m_parts.client.draw(eye, image, seen);
            m_clock.endPhase(FramePhase::Draw);
        });
        m_clock.endPhase(FramePhase::Images);
    }
}

void HeadsetLoop::count(const FrameTime& time, Clock::time_point begun, bool isShown)
{
    FrameTiming& timing = m_clock.timing();
    const double drawn = m_parts.client.drawCallMs();
    timing.drawCallMs = drawn - std::exchange(m_drawCallMs, drawn);
    timing.workMs = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
    timing.periodMs = static_cast<double>(time.period) / 1e6;
    timing.dropped = m_dropped.count(time.display, time.period, isShown);
    timing.isShown = isShown;
    m_parts.timings.add(timing);
    m_clock.reset();
}
} // namespace vr
