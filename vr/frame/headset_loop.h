#pragma once

#include "vr/frame/frame_client.h"
#include "vr/frame/headset_report.h"
#include "vr/gl/gl_context.h"
#include "vr/openxr/session_state.h"
#include "vr/openxr/xr_actions.h"
#include "vr/openxr/xr_hand_trackers.h"
#include "vr/openxr/xr_session.h"
#include "vr/openxr/xr_spaces.h"
#include "vr/openxr/xr_views.h"

#include <chrono>
#include <functional>
#include <stop_token>

namespace vr
{
/// One visit to VR, from the beginning of an OpenXR session to its end: handles events and renders frames in turn.
///
/// The constructor and run() throw XrError. Thread: all calls on one thread.
class HeadsetLoop
{
public:
    struct Parts
    {
        const Instance& instance; ///< precondition: its status is Ready
        const GlBinding& binding;
        GlContext& gl; ///< precondition: claimed by this thread
        FrameClient& client;
        FrameTimings& timings;
        std::stop_token stop;
        std::function<void(HeadsetStage)> onStage; ///< called when the stage of the visit has changed
    };

    explicit HeadsetLoop(const Parts& parts);
    ~HeadsetLoop();
    HeadsetLoop(const HeadsetLoop&) = delete;
    HeadsetLoop& operator=(const HeadsetLoop&) = delete;

    HeadsetEnd run();

private:
    using Clock = std::chrono::steady_clock;

    std::optional<HeadsetEnd> pollEvents();
    std::optional<HeadsetEnd> handleEvent(const XrEvent& event);
    std::optional<HeadsetEnd> handleEvent(const XrEventDataSessionStateChanged& event);
    std::optional<HeadsetEnd> exitIfRequested();
    HeadsetStage stage() const;
    void reportStage();
    void idle();
    void renderFrame();
    FrameInput readInput(const FrameTime& time);
    void handle(const FrameOutput& output);
    void drawViews();
    void count(const FrameTime& time, Clock::time_point begun, bool isShown);

    Parts m_parts;
    Session m_session;
    Actions m_actions;
    HandTrackers m_handTrackers;
    Spaces m_spaces;
    Views m_views;
    SessionStatus m_status;
    HeadsetStage m_stage = HeadsetStage::Starting; ///< last stage passed to onStage
    HeadsetStage m_seenStage = HeadsetStage::Starting;
    Clock::time_point m_seenSince;
    Clock::time_point m_exitDeadline; ///< time to give up waiting for the session's end; set when the exit is requested
    bool m_exitRequested = false;     ///< the client has asked to leave
    bool m_areProfilesStale = false;
    std::optional<Pose> m_head;
    PhaseTimer m_clock;
    double m_drawCallMs; ///< client's drawCallMs() after the last frame, milliseconds
    DroppedFrameCounter m_dropped;
};
} // namespace vr
