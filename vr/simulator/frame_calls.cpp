#include "vr/simulator/calls.h"
#include "vr/simulator/enum_names.h"
#include "vr/simulator/layers.h"

#include <thread>

namespace simulator
{
namespace
{
using Clock = std::chrono::steady_clock;
using std::chrono::nanoseconds;

/// Longest time that xrWaitFrame waits for xrBeginFrame of the frame before.
constexpr auto patience = std::chrono::seconds(10);

bool isGone(const Session& session)
{
    return !session.isRunning() || session.lost || session.parent->lost;
}

void waitUntilBegun(Call& call, Session& session)
{
    const bool isBegun =
        call.runtime.changed.wait_for(call.lock, patience, [&] { return !session.waited || isGone(session); });
    if (!isBegun)
        call.error("the frame that was waited for before is not begun");
    require(isBegun, XR_ERROR_RUNTIME_FAILURE, "waited in vain for xrBeginFrame");
}

void waitUntilAllowed(Call& call, Session& session)
{
    Runtime& runtime = call.runtime;
    runtime.isClientWaiting = true;
    runtime.changed.notify_all();
    runtime.changed.wait(
        call.lock, [&] { return runtime.world.pace != Pace::Stepped || runtime.framesAllowed > 0 || isGone(session); });
    runtime.isClientWaiting = false;
    if (runtime.framesAllowed > 0)
        --runtime.framesAllowed;
}

/// Returns when the next frame's interval begins. The intervals of a live display follow each other by the clock; a
/// frame that misses its interval is late.
Clock::time_point nextStart(SimulatedWorld& world, const Session& session)
{
    const XrDuration period = world.period();
    const bool isPaced = world.pace == Pace::Real || world.pace == Pace::Live;
    const auto due = session.frameStart + nanoseconds(isPaced ? period : 0);
    const auto now = Clock::now();
    if (world.pace != Pace::Live || session.nextFrame == 0 || now <= due)
        return std::max(now, due) + nanoseconds(world.late);
    world.late += (nanoseconds(now - due).count() + period - 1) / period * period;
    return due + nanoseconds(world.late);
}

void waitForDisplay(Call& call, Session& session)
{
    const auto start = nextStart(call.runtime.world, session);
    call.lock.unlock();
    std::this_thread::sleep_until(start);
    call.lock.lock();
    session.frameStart = start;
}

/// Advances the display time by one period, and by one more for each period or part of one that the frame is late.
Frame nextFrame(Runtime& runtime, Session& session)
{
    SimulatedWorld& world = runtime.world;
    const XrDuration period = world.period();
    const XrDuration missed = (world.late + period - 1) / period;
    world.now += period * (1 + missed);
    world.late = 0;
    return {session.nextFrame++, world.now};
}

void applyScript(Runtime& runtime, const Session& session)
{
    if (const ScriptStep* step = runtime.script.at({session.index, session.nextFrame}))
        runtime.apply(*step);
    runtime.loseIfDue();
}
} // namespace

XrResult waitFrame(Call& call, XrSession handle, const XrFrameWaitInfo* info, XrFrameState* state)
{
    Session& session = call.get<Session>(handle);
    Runtime& runtime = call.runtime;
    if (info)
        validated(info, XR_TYPE_FRAME_WAIT_INFO);
    validated(state, XR_TYPE_FRAME_STATE);
    requireRunning(session);
    waitUntilBegun(call, session);
    applyScript(runtime, session);
    waitUntilAllowed(call, session);
    waitForDisplay(call, session);
    requireRunning(call.get<Session>(handle)); // the session may have changed during the wait
    const Frame frame = nextFrame(runtime, session);
    session.waited = frame;
    state->predictedDisplayTime = frame.displayTime;
    state->predictedDisplayPeriod = runtime.world.period();
    state->shouldRender = session.isShown() && runtime.world.shouldRender ? XR_TRUE : XR_FALSE;
    call.line.update({{"display_time", frame.displayTime}, {"should_render", state->shouldRender == XR_TRUE}});
    return XR_SUCCESS;
}

XrResult beginFrame(Call& call, XrSession handle, const XrFrameBeginInfo* info)
{
    Session& session = call.get<Session>(handle);
    if (info)
        validated(info, XR_TYPE_FRAME_BEGIN_INFO);
    requireRunning(session);
    call.checkContext(session);
    require(session.waited.has_value(), XR_ERROR_CALL_ORDER_INVALID, "no frame was waited for");
    const bool discards = session.begun.has_value();
    if (discards)
        call.error("the frame that was begun before is not ended");
    session.begun = std::exchange(session.waited, std::nullopt);
    call.runtime.changed.notify_all();
    return discards ? XR_FRAME_DISCARDED : XR_SUCCESS;
}

XrResult endFrame(Call& call, XrSession handle, const XrFrameEndInfo* info)
{
    Session& session = call.get<Session>(handle);
    Runtime& runtime = call.runtime;
    validated(info, XR_TYPE_FRAME_END_INFO);
    requireRunning(session);
    call.checkContext(session);
    require(session.begun.has_value(), XR_ERROR_CALL_ORDER_INVALID, "no frame was begun");
    const Frame frame = *session.begun;
    const Layers layers = checkedLayers(call, session, *info);
    if (info->displayTime != frame.displayTime)
        call.warn("the display time is not the one that xrWaitFrame predicted for this frame");
    keepPictures(runtime, session, frame, layers);
    showPicture(runtime, session, layers);
    runtime.log.frame({{"session", session.index},
                       {"number", frame.number},
                       {"display_time", frame.displayTime},
                       {"state", nameOf(session.state())},
                       {"blend_mode", nameOf(layers.blendMode)},
                       {"layers", layers.description}});
    session.begun.reset();
    ++runtime.framesEnded;
    session.raiseState();
    runtime.changed.notify_all();
    return XR_SUCCESS;
}
} // namespace simulator
