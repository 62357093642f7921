#include "vr/openxr/session_state.h"

namespace vr
{
SessionStep nextStep(const SessionStatus& status, XrSessionState state)
{
    switch (state) {
    case XR_SESSION_STATE_IDLE:
        return status.isExiting && !status.isRunning ? SessionStep::Exit : SessionStep::Continue;
    case XR_SESSION_STATE_READY:
        if (status.isRunning)
            return SessionStep::Continue;
        return status.isExiting ? SessionStep::Exit : SessionStep::Begin;
    case XR_SESSION_STATE_STOPPING:
        return status.isRunning ? SessionStep::End : SessionStep::Continue;
    case XR_SESSION_STATE_EXITING:
        return SessionStep::Exit;
    case XR_SESSION_STATE_LOSS_PENDING:
        return SessionStep::Lost;
    default:
        return SessionStep::Continue;
    }
}

SessionStatus afterStep(SessionStatus status, XrSessionState state)
{
    const SessionStep step = nextStep(status, state);
    status.state = state;
    if (step == SessionStep::Begin)
        status.isRunning = true;
    if (step == SessionStep::End)
        status.isRunning = false;
    return status;
}
} // namespace vr
