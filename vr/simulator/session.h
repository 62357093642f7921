#pragma once

#include "vr/simulator/gl_share.h"
#include "vr/simulator/instance.h"
#include "vr/simulator/session_input.h"

#include <chrono>

namespace simulator
{
class Runtime;

struct Frame
{
    std::int64_t number = 0; ///< number of the frame since the session was made
    XrTime displayTime = 0;
};

/// A session and its state, as the specification defines it. The state rises by one (for example from VISIBLE
/// to FOCUSED) with each frame that ends, and falls immediately.
class Session : public Object
{
public:
    Session(Runtime& runtime, std::shared_ptr<ShareContext> gl);

    XrSession handle() const { return std::bit_cast<XrSession>(number); }
    XrSessionState state() const { return m_state; }
    bool isRunning() const { return m_isRunning; }
    bool isFocused() const { return m_state == XR_SESSION_STATE_FOCUSED; }
    bool isShown() const { return m_state == XR_SESSION_STATE_VISIBLE || isFocused(); }

    /// Enters IDLE, then READY if the headset is worn. To be called when the session has its handle.
    void open();
    void begin(XrViewConfigurationType views);
    void end();
    void requestExit();
    /// Lowers the state to the highest that the world allows. An idle session becomes ready, or exits if that was
    /// requested.
    void updateState();
    /// Raises the state by one, if the world allows it.
    void raiseState();
    void announceLoss() { enter(XR_SESSION_STATE_LOSS_PENDING); }

    const std::shared_ptr<ShareContext>& gl() const { return m_gl; }
    XrViewConfigurationType views() const { return m_views; }
    Instance& instance() const;

    std::int64_t index = 0; ///< number of this session, from 0, since the script was loaded
    std::int64_t nextFrame = 0;
    /// Waited: frame that is not begun yet; begun: frame that is not ended yet.
    std::optional<Frame> waited, begun;
    std::chrono::steady_clock::time_point frameStart; ///< beginning of the last frame's interval
    std::optional<std::int64_t> lostAt;               ///< frame in which the session is lost
    SessionInput input;

private:
    void enter(XrSessionState state);
    bool mustStop() const;
    XrSessionState highestState() const;

    Runtime& m_runtime;
    std::shared_ptr<ShareContext> m_gl;
    XrSessionState m_state = XR_SESSION_STATE_UNKNOWN;
    XrViewConfigurationType m_views = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    bool m_isRunning = false;
    bool m_exitRequested = false;
};

inline void requireRunning(const Session& session)
{
    require(session.isRunning(), XR_ERROR_SESSION_NOT_RUNNING, "the session is not running");
}
} // namespace simulator
