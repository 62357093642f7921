#include "vr/simulator/session.h"

#include "vr/simulator/runtime.h"

namespace simulator
{
Session::Session(Runtime& runtime, std::shared_ptr<ShareContext> gl)
    : index(runtime.sessionsMade++)
    , m_runtime(runtime)
    , m_gl(std::move(gl))
{}

Instance& Session::instance() const
{
    return static_cast<Instance&>(*parent);
}

void Session::enter(XrSessionState state)
{
    m_state = state;
    instance().events.push(XrEventDataSessionStateChanged{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED, nullptr, handle(),
                                                          state, m_runtime.world.now});
}

void Session::open()
{
    enter(XR_SESSION_STATE_IDLE);
    updateState();
}

void Session::begin(XrViewConfigurationType views)
{
    m_isRunning = true;
    m_views = views;
    waited.reset();
    begun.reset();
    updateState();
}

void Session::end()
{
    m_isRunning = false;
    enter(XR_SESSION_STATE_IDLE);
    updateState();
}

void Session::requestExit()
{
    m_exitRequested = true;
    updateState();
}

bool Session::mustStop() const
{
    return m_exitRequested || !m_runtime.world.isWorn;
}

XrSessionState Session::highestState() const
{
    if (mustStop() || !m_runtime.world.isVisible)
        return XR_SESSION_STATE_SYNCHRONIZED;
    return m_runtime.world.hasFocus ? XR_SESSION_STATE_FOCUSED : XR_SESSION_STATE_VISIBLE;
}

// States are stepped by arithmetic: the enumerators from READY to FOCUSED are consecutive.
void Session::updateState()
{
    if (m_state == XR_SESSION_STATE_IDLE && m_exitRequested)
        enter(XR_SESSION_STATE_EXITING);
    else if (m_state == XR_SESSION_STATE_IDLE && m_runtime.world.isWorn)
        enter(XR_SESSION_STATE_READY);
    if (!m_isRunning || m_state > XR_SESSION_STATE_FOCUSED)
        return;
    while (m_state > highestState())
        enter(static_cast<XrSessionState>(m_state - 1));
    if (!mustStop())
        return;
    if (m_state == XR_SESSION_STATE_READY)
        enter(XR_SESSION_STATE_SYNCHRONIZED);
    enter(XR_SESSION_STATE_STOPPING);
}

void Session::raiseState()
{
    if (m_isRunning && m_state < highestState())
        enter(static_cast<XrSessionState>(m_state + 1));
}
} // namespace simulator
