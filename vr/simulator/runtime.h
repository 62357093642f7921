#pragma once

#include "vr/simulator/call_log.h"
#include "vr/simulator/handles.h"
#include "vr/simulator/picture.h"
#include "vr/simulator/script.h"
#include "vr/simulator/simulated_world.h"

#include <condition_variable>
#include <mutex>
#include <optional>

namespace simulator
{
class Instance;
class Session;

/// A move of the origin of a reference space.
struct Recentring
{
    XrReferenceSpaceType space = XR_REFERENCE_SPACE_TYPE_LOCAL;
    vr::Pose origin;        ///< new origin in the room
    std::int64_t after = 0; ///< frames from the event to the change
};

/// The state of the simulated runtime, one object in a process. It survives when the loader unloads the library, so
/// that a client can connect again. `mutex` guards it: every call into the runtime and every function of control_api.h
/// holds the mutex, except while it waits.
class Runtime
{
public:
    static Runtime& get();

    /// Resets the state to the start of a script, with the log and the picture folder that the environment names.
    /// Throws std::exception.
    void load(const std::string& script);
    /// Loads the script that the environment names, unless a script was loaded. Throws std::exception.
    void loadOnce();
    /// Applies the changes of a step at the next frame's time, and wakes all waiting calls.
    void apply(const ScriptStep& step);

    /// Returns the number that the session's next frame will have; 0 without a session.
    std::int64_t nextFrame() const;
    /// Moves the origin of a reference space, and sends the session the event.
    void recentre(const Recentring& recentring);
    /// Hides a fraction of the pictures' sides at their corners, and sends the session the events.
    void hide(double share);
    /// Announces that the session will be lost after `afterFrames` frames.
    void loseSession(std::int64_t afterFrames);
    /// Announces that the instance will be lost after `afterFrames` frames.
    void loseInstance(std::int64_t afterFrames);
    /// Loses the session and the instance if their announced frame has come.
    void loseIfDue();
    /// Asks the client to end the session.
    void exitSession();

    /// Returns the log and the present state as JSON.
    nlohmann::json report() const;

    std::mutex mutex;
    std::condition_variable changed; ///< notified of every change that a call may wait for
    SimulatedWorld world;
    Script script;
    CallLog log;
    Handles handles;
    std::shared_ptr<Instance> instance; ///< the only instance; null: none
    std::shared_ptr<Session> session;   ///< the only session; null: none
    std::int64_t sessionsMade = 0;
    std::int64_t framesEnded = 0;   ///< frames ended since the process began
    std::int64_t framesAllowed = 0; ///< frames that the client may still wait for, with pace Stepped
    bool isClientWaiting = false;   ///< the client waits until a frame is allowed, with pace Stepped
    bool isClientFrozen = false;    ///< the client is in a call that does not return
    std::string pictureFolder;      ///< folder for pictures of frames; empty: no pictures are kept
    bool isPictureWanted = false;   ///< the next frame's picture is to be stored in `picture`
    std::optional<Picture> picture; ///< newest picture that was wanted

private:
    Runtime() = default;
    bool m_isLoaded = false;
};
} // namespace simulator
