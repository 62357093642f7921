#pragma once

#include <openxr/openxr.h>

namespace vr
{
/// Where one session is in OpenXR's life cycle.
struct SessionStatus
{
    XrSessionState state = XR_SESSION_STATE_UNKNOWN; ///< the last one that the runtime reported
    bool isRunning = false;                          ///< begun and not ended: it has frames
    bool isExiting = false;                          ///< we have asked it to exit, or would have if it ran

    bool hasInput() const { return isRunning && state == XR_SESSION_STATE_FOCUSED; }
    bool isVisible() const { return hasInput() || (isRunning && state == XR_SESSION_STATE_VISIBLE); }
};

enum class SessionStep {
    Continue,
    Begin, ///< xrBeginSession
    End,   ///< xrEndSession
    Exit,  ///< destroy it: it is over
    Lost   ///< destroy it: it has died
};

/// The call to make when the runtime reports `state`. Never returns a call that is invalid in the current status, even
/// if the runtime misbehaves.
SessionStep nextStep(const SessionStatus& status, XrSessionState state);

/// The status after that call.
SessionStatus afterStep(SessionStatus status, XrSessionState state);
} // namespace vr
