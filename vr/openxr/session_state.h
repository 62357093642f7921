#pragma once

#include <openxr/openxr.h>

namespace vr
{
/// A session's state in the life cycle of OpenXR.
struct SessionStatus
{
    XrSessionState state = XR_SESSION_STATE_UNKNOWN; ///< the last one that the runtime reported
    /// xrBeginSession was called and xrEndSession was not: the session has frames.
    bool isRunning = false;
    /// Fettle has asked the session to exit; the session may have stopped since.
    bool isExiting = false;

    bool hasInput() const { return isRunning && state == XR_SESSION_STATE_FOCUSED; }
    bool isVisible() const { return hasInput() || (isRunning && state == XR_SESSION_STATE_VISIBLE); }
};

enum class SessionStep {
    Continue,
    Begin, ///< call xrBeginSession
    End,   ///< call xrEndSession
    Exit,  ///< destroy the session: it has ended
    Lost   ///< destroy the session: it is lost
};

/// Returns the call to make when the runtime reports `state`. Never returns a call that is invalid in the current
/// status, even if the runtime misbehaves.
SessionStep nextStep(const SessionStatus& status, XrSessionState state);

/// Returns the status after the call that nextStep() returns.
SessionStatus afterStep(SessionStatus status, XrSessionState state);
} // namespace vr
