#pragma once

#include "vr/frame/frame_client.h"
#include "vr/gl/gl_context.h"
#include "vr/frame/headset_report.h"
#include "vr/openxr/session_state.h"
#include "vr/openxr/xr_actions.h"
#include "vr/openxr/xr_views.h"
#include "vr/openxr/xr_session.h"
#include "vr/openxr/xr_spaces.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace vr
{
/// Rings when the visit is to end. Any thread.
class LeaveBell
{
public:
    void ring();
    bool hasRung() const;
    /// Until it rings, or that time is over.
    void wait(std::chrono::milliseconds time);

private:
    mutable std::mutex m_mutex; ///< of the next
    bool m_hasRung = false;
    std::condition_variable m_wake;
};

/// One visit to the headset from a session's beginning to its end: events, frames, events, frames. All on one thread; the constructor and
/// run() throw XrError.
class HeadsetLoop
{
public:
    struct Parts
    {
        const Instance& instance; ///< Ready
        const GlBinding& binding;
        GlContext& gl; ///< taken
        FrameClient& client;
        FrameCosts& costs;
        LeaveBell& bell;
        std::function<void(HeadsetStage)> tell; ///< of each change
    };

    explicit HeadsetLoop(const Parts& parts);
    ~HeadsetLoop();
    HeadsetLoop(const HeadsetLoop&) = delete;
    HeadsetLoop& operator=(const HeadsetLoop&) = delete;

    HeadsetEnd run();

private:
    using Clock = std::chrono::steady_clock;

    std::optional<HeadsetEnd> takeEvents();
    std::optional<HeadsetEnd> take(const XrEvent& event);
    std::optional<HeadsetEnd> take(const XrEventDataSessionStateChanged& event);
    std::optional<HeadsetEnd> leaveIfWanted();
    HeadsetStage stage() const;
    void tellStage();
    void rest();
    void makeFrame();
    FrameInput readInput(const FrameTime& time);
    void obey(const FrameOutput& output);
    void drawEyes();
    void count(const FrameTime& time, Clock::time_point begun, bool isShown);

    Parts m_parts;
    Session m_session;
    Actions m_actions;
    Spaces m_spaces;
    Eyes m_eyes;
    SessionStanding m_standing;
    HeadsetStage m_stage = HeadsetStage::Starting; ///< the last that was told
    HeadsetStage m_seenStage = HeadsetStage::Starting;
    Clock::time_point m_seenSince;
    Clock::time_point m_patience; ///< the end of it, once we are leaving
    bool m_wantsToLeave = false;  ///< the client
    bool m_areKindsOld = false;
    std::optional<Pose> m_head;
    PhaseClock m_clock;
    double m_drawnMs; ///< as the client said after the last frame
    LostFrames m_lost;
};
} // namespace vr
