#include "vr/openxr/session_state.h"

namespace vr
{
SessionStep nextStep(const SessionStanding& standing, XrSessionState told)
{
    switch (told) {
    case XR_SESSION_STATE_IDLE:
        return standing.isLeaving && !standing.isRunning ? SessionStep::Leave : SessionStep::KeepOn;
    case XR_SESSION_STATE_READY:
        if (standing.isRunning)
            return SessionStep::KeepOn;
        return standing.isLeaving ? SessionStep::Leave : SessionStep::Begin;
    case XR_SESSION_STATE_STOPPING: return standing.isRunning ? SessionStep::End : SessionStep::KeepOn;
    case XR_SESSION_STATE_EXITING: return SessionStep::Leave;
    case XR_SESSION_STATE_LOSS_PENDING: return SessionStep::Lost;
    default: return SessionStep::KeepOn;
    }
}

SessionStanding afterStep(SessionStanding standing, XrSessionState told)
{
    const SessionStep step = nextStep(standing, told);
    standing.state = told;
    if (step == SessionStep::Begin)
        standing.isRunning = true;
    if (step == SessionStep::End)
        standing.isRunning = false;
    return standing;
}
} // namespace vr
