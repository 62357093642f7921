#pragma once

#include <openxr/openxr.h>

namespace vr
{
/// How things stand between us and the runtime, for one session.
struct SessionStanding
{
    XrSessionState state = XR_SESSION_STATE_UNKNOWN; ///< the last one that the runtime told
    bool isRunning = false;                          ///< begun and not ended: it has frames
    bool isLeaving = false;                          ///< we have asked it to exit, or would have if it ran

    bool hasInput() const { return isRunning && state == XR_SESSION_STATE_FOCUSED; }
    bool isVisible() const { return hasInput() || (isRunning && state == XR_SESSION_STATE_VISIBLE); }
};

enum class SessionStep {
    KeepOn,
    Begin, ///< xrBeginSession
    End,   ///< xrEndSession
    Leave, ///< destroy it: it is over
    Lost   ///< destroy it: it has died
};

/// What a change of the session's state asks of us. Steps that OpenXR forbids as things stand are never asked, whatever the runtime tells.
SessionStep nextStep(const SessionStanding& standing, XrSessionState told);

/// How things stand when the step has been taken.
SessionStanding afterStep(SessionStanding standing, XrSessionState told);
} // namespace vr
